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

/// Blocks of each replicate: equal, so that all have seen the same part of their sequences.
std::uint64_t BlocksPerReplicate(const TraceSettings& settings)
{
  const std::uint64_t round = settings.replicates * PhotonBlock;
  return (settings.photons + round - 1) / round;
}

/// Blocks traced between two additions of the threads' sums: enough that adding costs little.
std::uint64_t SliceSize(const Scene& scene)
{
  constexpr std::uint64_t AtLeast = 256;
  return std::max<std::uint64_t>(AtLeast, 2 * scene.Vertices().size() / PhotonBlock);
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
    const std::uint64_t blocks = BlocksPerReplicate(this->Settings);
    const std::uint64_t slice = SliceSize(this->Surroundings);
    const auto total = static_cast<double>(blocks * this->Settings.replicates);
    std::uint64_t before = 0;
    const Monitor report = [&](std::uint64_t done)
    { return monitor(static_cast<double>(before + done) / total); };
    for (std::uint64_t first = 0; first < blocks; first += slice)
    {
      const std::uint64_t count = std::min(slice, blocks - first);
      for (std::uint32_t r = 0; r < this->Settings.replicates; ++r)
      {
        if (!this->Tracer.Trace(r, first, count, this->Replicates[r], monitor ? report : Monitor()))
        {
          return false;
        }
        before += count;
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
    map.fluxCutByWeightBound = emitted > 0.0 ? map.flux / emitted * FromCoarseFixedPoint(cut) : 0.0;
    map.front = this->Side(&IlluminationSums::front, map);
    if (this->Settings.registerBackSide)
    {
      map.back = this->Side(&IlluminationSums::back, map);
    }
    return map;
  }

private:
  /// E_i = (flux / N) V_i / A_i.
  SideMap Side(std::vector<VertexSums> IlluminationSums::*side, const IlluminationMap& map) const
  {
    const std::vector<double>& areas = this->Surroundings.VertexAreas();
    const std::size_t vertices = areas.size();
    SideMap result{ std::vector<double>(vertices, 0.0), std::vector<double>(vertices, 0.0),
      std::vector<double>(vertices, 0.0), std::vector<std::uint64_t>(vertices, 0) };
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
        total += sums;
        const auto photons = static_cast<double>(replicate.balance.emitted);
        statistics.Add(FromFixedPoint(sums.direct + sums.indirect) / photons, photons);
      }
      const double luxPerWeight = map.flux / areas[v];
      result.direct[v] = luxPerWeight * FromFixedPoint(total.direct) / emitted;
      result.indirect[v] = luxPerWeight * FromFixedPoint(total.indirect) / emitted;
      result.standardError[v] = luxPerWeight * statistics.StandardError();
      result.photonHits[v] = total.hits;
    }
    return result;
  }

  const Scene& Surroundings;
  TraceSettings Settings;
  PhotonTracer Tracer;
  std::vector<IlluminationSums> Replicates;
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
