// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/IlluminationMap.h"

#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/transport/PhotonTracer.h"

#include <algorithm>
#include <chrono>

namespace PhotonTransport
{
namespace
{

/// Photons of replicate `r` when `total` are dealt out as evenly as they go.
std::uint64_t ShareOf(std::uint64_t total, std::uint32_t replicates, std::uint32_t r)
{
  return total / replicates + (r < total % replicates ? 1 : 0);
}

/// Photons traced between two additions of the threads' sums: enough that adding costs little.
std::uint64_t SliceSize(const Scene& scene)
{
  constexpr std::uint64_t AtLeast = 1u << 16;
  return std::max<std::uint64_t>(AtLeast, 2 * scene.Vertices().size());
}

class Run
{
public:
  Run(const Scene& scene, const Lamp& lamp, const TraceSettings& settings)
    : Surroundings(scene)
    , Settings(settings)
    , Tracer(scene, lamp, settings)
    , Replicates(settings.replicates, this->Tracer.EmptySums())
  {
  }

  /// Advances all replicates in turn, so that a stopped run has spent about the same on each.
  bool TraceAll(const ProgressMonitor& monitor)
  {
    const std::uint64_t slice = SliceSize(this->Surroundings);
    const std::uint64_t most = ShareOf(this->Settings.photons, this->Settings.replicates, 0);
    for (std::uint64_t first = 0; first < most; first += slice)
    {
      for (std::uint32_t r = 0; r < this->Settings.replicates; ++r)
      {
        const std::uint64_t share = ShareOf(this->Settings.photons, this->Settings.replicates, r);
        if (first < share && !this->TraceSlice(r, first, std::min(slice, share - first), monitor))
        {
          return false;
        }
      }
    }
    return true;
  }

  IlluminationMap Result() const
  {
    IlluminationMap map;
    map.flux = this->Tracer.Flux();
    map.effects = this->Tracer.EffectsInUse().reasons;
    FixedPoint cut = 0;
    for (const IlluminationSums& replicate : this->Replicates)
    {
      map.balance += replicate.balance;
      cut += replicate.cutByWeightBound;
    }
    const auto emitted = static_cast<double>(map.balance.emitted);
    map.fluxCutByWeightBound =
      emitted > 0.0 ? map.flux / emitted * FromCoarseFixedPoint(cut) : 0.0;
    map.front = this->Side(&IlluminationSums::front, map);
    if (this->Settings.registerBackSide)
    {
      map.back = this->Side(&IlluminationSums::back, map);
    }
    map.photonHits = this->Hits();
    return map;
  }

private:
  bool TraceSlice(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
    const ProgressMonitor& monitor)
  {
    const std::uint64_t before = this->Traced;
    this->Traced += count;
    const auto total = static_cast<double>(this->Settings.photons);
    const auto report = [&](std::uint64_t done) {
      return monitor(static_cast<double>(before + done) / total);
    };
    return this->Tracer.Trace(replicate, first, count, this->Replicates[replicate],
      monitor ? Monitor(report) : Monitor());
  }

  /// E_i = (flux / N) V_i / A_i.
  SideMap Side(std::vector<VertexSums> IlluminationSums::*side, const IlluminationMap& map) const
  {
    const std::vector<double>& areas = this->Surroundings.VertexAreas();
    const std::size_t vertices = areas.size();
    SideMap result{ std::vector<double>(vertices, 0.0), std::vector<double>(vertices, 0.0),
      std::vector<double>(vertices, 0.0) };
    const auto emitted = static_cast<double>(map.balance.emitted);
    if (!(emitted > 0.0))
    {
      return result;
    }
    for (std::size_t v = 0; v < vertices; ++v)
    {
      if (!(areas[v] > 0.0))
      {
        continue;
      }
      VertexSums total;
      ReplicateStatistics statistics;
      for (const IlluminationSums& replicate : this->Replicates)
      {
        const VertexSums& sums = (replicate.*side)[v];
        total.direct += sums.direct;
        total.indirect += sums.indirect;
        const auto photons = static_cast<double>(replicate.balance.emitted);
        statistics.Add(FromFixedPoint(sums.direct + sums.indirect) / photons, photons);
      }
      const double luxPerWeight = map.flux / areas[v];
      result.direct[v] = luxPerWeight * FromFixedPoint(total.direct) / emitted;
      result.indirect[v] = luxPerWeight * FromFixedPoint(total.indirect) / emitted;
      result.standardError[v] = luxPerWeight * statistics.StandardError();
    }
    return result;
  }

  std::vector<std::uint64_t> Hits() const
  {
    std::vector<std::uint64_t> hits(this->Surroundings.Vertices().size(), 0);
    for (std::size_t f = 0; f < this->Surroundings.Facets().size(); ++f)
    {
      std::uint64_t onFacet = 0;
      for (const IlluminationSums& replicate : this->Replicates)
      {
        onFacet += replicate.frontHits[f];
      }
      const glm::uvec3& corners = this->Surroundings.Facets()[f].vertices;
      for (int corner = 0; corner < 3; ++corner)
      {
        hits[corners[corner]] += onFacet;
      }
    }
    return hits;
  }

  const Scene& Surroundings;
  TraceSettings Settings;
  PhotonTracer Tracer;
  std::vector<IlluminationSums> Replicates;
  std::uint64_t Traced = 0;
};

} // namespace

IlluminationMap TraceIlluminationMap(const Scene& scene, const Lamp& lamp,
  const TraceSettings& settings, const ProgressMonitor& monitor)
{
  const auto start = std::chrono::steady_clock::now();
  Run run(scene, lamp, settings);
  const bool complete = run.TraceAll(monitor);
  IlluminationMap map = run.Result();
  map.complete = complete;
  map.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return map;
}

} // namespace PhotonTransport
