// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/ReplicateSums.h"

#include "PhotonTransport/statistics/FewHits.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/LampSum.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <utility>

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

/// What replicates have counted for each source, added up.
template <typename Count>
std::vector<Count> BySource(
  const std::vector<IlluminationSums>& replicates, std::vector<Count> IlluminationSums::*counts)
{
  std::vector<Count> all((replicates.front().*counts).size());
  for (const IlluminationSums& replicate : replicates)
  {
    for (std::size_t source = 0; source < all.size(); ++source)
    {
      all[source] += (replicate.*counts)[source];
    }
  }
  return all;
}

} // namespace

ReplicateSums::ReplicateSums(std::size_t numberOfReplicates, IlluminationSums empty)
  : front(empty.front.size(), numberOfReplicates, Groups, empty.lamps)
  , back(empty.back.size(), numberOfReplicates, 1, empty.lamps)
  , layers(std::exchange(empty.layers, {}))
  , colours(layers.HasColour() ? numberOfReplicates : 0,
      std::vector<FixedPoint>(LightLayers::Channels * empty.front.size(), 0))
{
  empty.front = {};
  empty.back = {};
  this->replicates.assign(numberOfReplicates, empty);
}

void ReplicateSums::Add(std::size_t replicate, IlluminationSums& sums)
{
  this->front.Add(replicate, sums.front);
  this->back.Add(replicate, sums.back);
  this->AddColours(replicate, sums.layers);
  MoveInto(this->layers, sums.layers);
  MoveCounts(this->replicates[replicate], sums);
}

PhotonBalance ReplicateSums::Balance() const
{
  PhotonBalance balance;
  for (const IlluminationSums& replicate : this->replicates)
  {
    balance += replicate.Balance();
  }
  return balance;
}

std::vector<PhotonBalance> ReplicateSums::BalancesBySource() const
{
  return BySource(this->replicates, &IlluminationSums::balances);
}

std::vector<Arrivals> ReplicateSums::ArrivalsBySource() const
{
  return BySource(this->replicates, &IlluminationSums::arrivals);
}

std::vector<double> ReplicateSums::CutByWeightBound() const
{
  const std::vector<FixedPoint> cut =
    BySource(this->replicates, &IlluminationSums::cutByWeightBound);
  std::vector<double> weights(cut.size());
  std::transform(cut.begin(), cut.end(), weights.begin(), FromCoarseFixedPoint);
  return weights;
}

IlluminationMap ReplicateSums::Map(
  Side side, const MapScale& scale, const LampFactors& factors) const
{
  IlluminationMap map = IlluminationMap::WithoutLight(scale.areas.size());
  const auto emitted = static_cast<double>(this->Balance().emitted);
  const SideSums& sums = this->*side;
  if (!(emitted > 0.0) || sums.Slots() == 0)
  {
    return map;
  }
  const LampSum sumOf(sums, factors);
  const std::vector<double> photons = this->PhotonsOfReplicates();
  // Weights come first, since what a hit adds on average is known only when all are there.
  ForEachWithArea(scale.areas,
    [&](std::size_t v)
    {
      ReplicateStatistics statistics;
      for (std::size_t r = 0; r < photons.size(); ++r)
      {
        statistics.Add(sumOf(sums.weights[r], v) / photons[r], photons[r]);
      }
      sumOf.AddTotals(v, map);
      map.standardError[v] = emitted * statistics.StandardError();
    });
  this->CountFewHits(sums, scale, factors, map);
  ForEachWithArea(scale.areas,
    [&](std::size_t v)
    {
      const double error = map.standardError[v];
      map.direct[v] = IlluminanceOf(scale.flux, scale.areas[v], map.direct[v], emitted);
      map.indirect[v] = IlluminanceOf(scale.flux, scale.areas[v], map.indirect[v], emitted);
      map.standardError[v] = IlluminanceOf(scale.flux, scale.areas[v], error, emitted);
    });
  return map;
}

std::vector<double> ReplicateSums::PhotonsOfReplicates() const
{
  std::vector<double> photons;
  for (const IlluminationSums& replicate : this->replicates)
  {
    photons.push_back(static_cast<double>(replicate.Balance().emitted));
  }
  return photons;
}

/// Makes errors as large as few hits call for. @param map Of weights.
void ReplicateSums::CountFewHits(const SideSums& sums, const MapScale& scale,
  const LampFactors& factors, IlluminationMap& map) const
{
  const HitsByWeight hits(sums, scale.startWeights, factors);
  if (hits.AreUnknown())
  {
    const FewHits few(FewHits::WithoutCompensation, this->CanTellSpread(), hits.CountingWeights());
    ForEachWithArea(scale.areas,
      [&](std::size_t v)
      {
        map.standardError[v] =
          few.StandardError(map.standardError[v], map.photonHits[v], map.Total(v));
      });
    return;
  }
  const FewHits few(hits.MeanWeight(map), this->CanTellSpread(), { hits.LargestWeight() });
  ForEachWithArea(scale.areas,
    [&](std::size_t v)
    {
      const WeightedHits own = hits.At(v, map.photonHits[v]);
      map.standardError[v] = few.StandardErrorOf(map.standardError[v], own.sum, own.squares);
    });
}

bool ReplicateSums::CanTellSpread() const
{
  const std::vector<double> photons = this->PhotonsOfReplicates();
  return std::count_if(photons.begin(), photons.end(), [](double n) { return n > 0.0; }) >= 2;
}

GroupMeans ReplicateSums::FrontByGroups(const MapScale& scale, const LampFactors& factors) const
{
  std::array<double, Groups> photons{};
  const std::vector<double> ofReplicates = this->PhotonsOfReplicates();
  for (std::size_t r = 0; r < ofReplicates.size(); ++r)
  {
    photons[r % Groups] += ofReplicates[r];
  }
  if (*std::min_element(photons.begin(), photons.end()) == 0.0)
  {
    return {};
  }
  const double all = std::accumulate(photons.begin(), photons.end(), 0.0);
  const LampSum sumOf(this->front, factors);
  using Sums = std::array<double, Groups>;
  // Sums of integers are exact as numbers: they are below 2^53, or it makes no difference.
  const auto meansOf = [&](std::size_t v, const Sums& sums)
  {
    GroupValues means{};
    double unweighted = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      means[g] = sums[g] / photons[g];
      unweighted += means[g] / Groups;
    }
    // Groups may differ in photons after a time limit; their plain mean must be that of the map.
    const double shift = std::accumulate(sums.begin(), sums.end(), 0.0) / all - unweighted;
    for (double& mean : means)
    {
      mean = IlluminanceOf(scale.flux, scale.areas[v], mean + shift, 1.0);
    }
    return means;
  };
  GroupMeans groups{ std::vector<GroupValues>(scale.areas.size()),
    std::vector<GroupValues>(scale.areas.size()) };
  ForEachWithArea(scale.areas,
    [&](std::size_t v)
    {
      Sums direct, indirect{};
      for (std::size_t r = 0; r < this->replicates.size(); ++r)
      {
        indirect[r % Groups] += sumOf(this->front.weights[r], v);
      }
      for (std::size_t g = 0; g < Groups; ++g)
      {
        direct[g] = sumOf(this->front.direct[g], v);
        indirect[g] = std::max(0.0, indirect[g] - direct[g]); // rounding may bring it below
      }
      groups.direct[v] = meansOf(v, direct);
      groups.indirect[v] = meansOf(v, indirect);
    });
  return groups;
}

bool ReplicateSums::AnyLight(Side side) const
{
  const SideSums& sums = this->*side;
  const bool cells = !this->replicates.front().cells.IsEmpty();
  if (cells) // they count on both sides, whichever are registered
  {
    return sums.Vertices() > 0 &&
      std::any_of(this->replicates.begin(), this->replicates.end(),
        [&](const IlluminationSums& replicate)
        { return replicate.cells.AnyOn(side == &ReplicateSums::front); });
  }
  return std::any_of(sums.weights.begin(), sums.weights.end(),
    [](const std::vector<FixedPoint>& weights)
    {
      return std::any_of(
        weights.begin(), weights.end(), [](FixedPoint weight) { return weight > 0; });
    });
}

bool ReplicateSums::AreFull() const
{
  constexpr FixedPoint Quarter = FixedPoint{ 1 } << 61;
  std::atomic<bool> full = false;
  for (const SideSums* sums : { &this->front, &this->back })
  {
    const std::size_t vertices = sums->Vertices();
    const std::size_t lamps = sums->lamps;
    ForEach(vertices,
      [&, vertices, lamps, sums = sums](std::size_t v)
      {
        FixedPoint sum = 0;
        for (const std::vector<FixedPoint>& weights : sums->weights)
        {
          sum += weights[v];
          for (std::size_t lamp = 1; lamp < lamps; ++lamp)
          {
            sum += weights[lamp * vertices + v];
          }
        }
        if (sum >= Quarter)
        {
          full = true;
        }
      });
  }
  for (const IlluminationSums& replicate : this->replicates)
  {
    full = full ||
      std::any_of(replicate.cells.all.begin(), replicate.cells.all.end(),
        [](std::uint32_t count) { return count >= CellCounts::Full; });
  }
  const std::vector<std::uint32_t>& byLamp = this->layers.lampCells.all;
  return full ||
    std::any_of(
      byLamp.begin(), byLamp.end(), [](std::uint32_t count) { return count >= CellCounts::Full; });
}

} // namespace PhotonTransport
