// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/ReplicateSums.h"

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/statistics/FewHits.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// Calls f(vertex) for each vertex that has an area, on many threads.
template <typename F>
void ForEachWithArea(const std::vector<double>& areas, const F& f)
{
  ForEach(areas.size(),
    [&](std::size_t v)
    {
      if (areas[v] > 0.0)
      {
        f(v);
      }
    });
}

/// What a hit adds to a vertex. It is added up in order, so that the same sums give the same bits.
/// @param sums Weights, where a map has illuminances.
double MeanWeight(const IlluminationMap& sums)
{
  constexpr double WithoutCompensation = 1.0 / 3.0;
  double weights = 0.0;
  double hits = 0.0;
  for (std::size_t v = 0; v < sums.direct.size(); ++v)
  {
    weights += sums.direct[v] + sums.indirect[v];
    hits += static_cast<double>(sums.photonHits[v]);
  }
  return weights > 0.0 ? weights / hits : WithoutCompensation;
}

} // namespace

PhotonBalance ReplicateSums::Balance() const
{
  PhotonBalance balance;
  for (const IlluminationSums& replicate : this->replicates)
  {
    balance += replicate.balance;
  }
  return balance;
}

std::vector<Arrivals> ReplicateSums::ArrivalsByLamp() const
{
  std::vector<Arrivals> arrivals(this->replicates.front().arrivals.size());
  for (const IlluminationSums& replicate : this->replicates)
  {
    for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
    {
      arrivals[lamp] += replicate.arrivals[lamp];
    }
  }
  return arrivals;
}

double ReplicateSums::CutByWeightBound() const
{
  FixedPoint cut = 0;
  for (const IlluminationSums& replicate : this->replicates)
  {
    cut += replicate.cutByWeightBound;
  }
  return FromCoarseFixedPoint(cut);
}

IlluminationMap ReplicateSums::Map(Side side, double flux, const std::vector<double>& areas) const
{
  const std::size_t vertices = areas.size();
  IlluminationMap map{ std::vector<double>(vertices, 0.0), std::vector<double>(vertices, 0.0),
    std::vector<double>(vertices, 0.0), std::vector<std::uint64_t>(vertices, 0) };
  const auto emitted = static_cast<double>(this->Balance().emitted);
  if (!(emitted > 0.0))
  {
    return map;
  }
  // Weights come first, since what a hit adds on average is known only when all are there.
  ForEachWithArea(areas,
    [&](std::size_t v)
    {
      VertexSums total;
      ReplicateStatistics statistics;
      for (const IlluminationSums& replicate : this->replicates)
      {
        const VertexSums& sums = (replicate.*side)[v];
        const auto photons = static_cast<double>(replicate.balance.emitted);
        total += sums;
        statistics.Add(FromFixedPoint(sums.direct + sums.indirect) / photons, photons);
      }
      map.direct[v] = FromFixedPoint(total.direct);
      map.indirect[v] = FromFixedPoint(total.indirect);
      map.standardError[v] = emitted * statistics.StandardError();
      map.photonHits[v] = total.hits;
    });
  const FewHits fewHits(MeanWeight(map), this->CanTellSpread());
  ForEachWithArea(areas,
    [&](std::size_t v)
    {
      const double error = fewHits.StandardError(map.standardError[v], map.photonHits[v]);
      map.direct[v] = IlluminanceOf(flux, areas[v], map.direct[v], emitted);
      map.indirect[v] = IlluminanceOf(flux, areas[v], map.indirect[v], emitted);
      map.standardError[v] = IlluminanceOf(flux, areas[v], error, emitted);
    });
  return map;
}

bool ReplicateSums::CanTellSpread() const
{
  return std::count_if(this->replicates.begin(), this->replicates.end(),
           [](const IlluminationSums& replicate) { return replicate.balance.emitted > 0; }) >= 2;
}

GroupMeans ReplicateSums::FrontByGroups(double flux, const std::vector<double>& areas) const
{
  std::array<double, Groups> photons{};
  for (std::size_t r = 0; r < this->replicates.size(); ++r)
  {
    photons[r % Groups] += static_cast<double>(this->replicates[r].balance.emitted);
  }
  if (*std::min_element(photons.begin(), photons.end()) == 0.0)
  {
    return {};
  }
  const double all = std::accumulate(photons.begin(), photons.end(), 0.0);
  const auto meansOf = [&](std::size_t v, FixedPoint VertexSums::*part)
  {
    std::array<FixedPoint, Groups> sums{};
    for (std::size_t r = 0; r < this->replicates.size(); ++r)
    {
      sums[r % Groups] += this->replicates[r].front[v].*part;
    }
    const FixedPoint total = std::accumulate(sums.begin(), sums.end(), FixedPoint{ 0 });
    GroupValues means{};
    double unweighted = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      means[g] = FromFixedPoint(sums[g]) / photons[g];
      unweighted += means[g] / Groups;
    }
    // Groups may differ in photons after a time limit; their plain mean must be that of the map.
    const double shift = FromFixedPoint(total) / all - unweighted;
    for (double& mean : means)
    {
      mean = IlluminanceOf(flux, areas[v], mean + shift, 1.0);
    }
    return means;
  };
  GroupMeans groups{ std::vector<GroupValues>(areas.size()),
    std::vector<GroupValues>(areas.size()) };
  ForEachWithArea(areas,
    [&](std::size_t v)
    {
      groups.direct[v] = meansOf(v, &VertexSums::direct);
      groups.indirect[v] = meansOf(v, &VertexSums::indirect);
    });
  return groups;
}

std::vector<std::array<double, 3>> ReplicateSums::FrontByColour(
  double flux, const std::vector<double>& areas) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  std::vector<std::array<double, 3>> front(this->layers.HasColour() ? areas.size() : 0);
  for (std::size_t v = 0; v < front.size(); ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      front[v][c] = IlluminanceOf(flux, areas[v], this->layers.Weights(v, c), emitted) /
        double{ LuminousWeights[static_cast<int>(c)] };
    }
  }
  return front;
}

std::vector<double> ReplicateSums::FrontOfLamp(
  std::size_t lamp, double flux, const std::vector<double>& areas) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  std::vector<double> front(areas.size(), 0.0);
  for (std::size_t v = 0; v < front.size() && this->layers.HasLamps(); ++v)
  {
    front[v] = IlluminanceOf(
      flux, areas[v], this->layers.Weights(v, this->layers.firstLamp + lamp), emitted);
  }
  return front;
}

bool ReplicateSums::AnyLight(Side side) const
{
  return std::any_of(this->replicates.begin(), this->replicates.end(),
    [&](const IlluminationSums& replicate)
    {
      return std::any_of((replicate.*side).begin(), (replicate.*side).end(),
        [](const VertexSums& sums) { return sums.direct + sums.indirect > 0; });
    });
}

bool ReplicateSums::AreFull() const
{
  constexpr FixedPoint Quarter = FixedPoint{ 1 } << 61;
  std::atomic<bool> full = false;
  const auto look = [&](Side side)
  {
    ForEach((this->replicates.front().*side).size(),
      [&](std::size_t v)
      {
        FixedPoint sum = 0;
        for (const IlluminationSums& replicate : this->replicates)
        {
          sum += (replicate.*side)[v].direct + (replicate.*side)[v].indirect;
        }
        if (sum >= Quarter)
        {
          full = true;
        }
      });
  };
  look(&IlluminationSums::front);
  look(&IlluminationSums::back);
  return full;
}

} // namespace PhotonTransport
