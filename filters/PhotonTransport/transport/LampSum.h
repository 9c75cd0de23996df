// SPDX-License-Identifier: BSD-3-Clause
// What lamps that are kept apart add up to.
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"
#include "PhotonTransport/statistics/FewHits.h"
#include "PhotonTransport/transport/MapScale.h"
#include "PhotonTransport/transport/SideSums.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What slots of a vertex add up to, each lamp's times its factor.
class LampSum
{
public:
  /// @param sums Must outlive it.
  LampSum(const SideSums& sums, const LampFactors& factors)
    : Sums(sums)
    , Exact(factors.empty())
    , IsPlain(factors.empty() && sums.lamps == 1)
  {
    for (std::size_t lamp = 0; lamp < sums.lamps; ++lamp)
    {
      if (this->Exact || factors[lamp] > 0.0)
      {
        this->Parts.push_back({ lamp * sums.Vertices(), this->Exact ? 1.0 : factors[lamp] });
      }
    }
  }

  /// @param slots [slot][layer] @param layer Of so many.
  double operator()(const std::vector<FixedPoint>& slots, std::size_t vertex, std::size_t layer = 0,
    std::size_t layers = 1) const
  {
    if (this->IsPlain)
    {
      return FromFixedPoint(slots[vertex * layers + layer]);
    }
    FixedPoint exact = 0;
    double sum = 0.0;
    for (const Part& part : this->Parts)
    {
      const FixedPoint own = slots[(part.firstSlot + vertex) * layers + layer];
      exact += own;
      sum += part.factor * FromFixedPoint(own);
    }
    return this->Exact ? FromFixedPoint(exact) : sum;
  }

  /// Direct and indirect light, and the hits of lamps that have light. @param map Of zeros.
  void AddTotals(std::size_t vertex, IlluminationMap& map) const
  {
    VertexSums exact;
    double direct = 0.0;
    double indirect = 0.0;
    for (const Part& part : this->Parts)
    {
      const VertexSums total = this->Sums.Total(part.firstSlot + vertex);
      exact += total;
      direct += part.factor * FromFixedPoint(total.direct);
      indirect += part.factor * FromFixedPoint(total.indirect);
    }
    map.direct[vertex] = this->Exact ? FromFixedPoint(exact.direct) : direct;
    map.indirect[vertex] = this->Exact ? FromFixedPoint(exact.indirect) : indirect;
    map.photonHits[vertex] = exact.hits;
  }

private:
  /// A lamp that has light.
  struct Part
  {
    std::size_t firstSlot;
    double factor;
  };
  const SideSums& Sums;
  bool Exact;   ///< All lamps count as they were traced, so sums are of integers.
  bool IsPlain; ///< There is one slot for each vertex, and it counts as it is.
  std::vector<Part> Parts;
};

/// Hits of a vertex by their start weights, over the largest of all.
struct WeightedHits
{
  double sum = 0.0;
  double squares = 0.0;
};

/// What tells the error of few hits, where it is known of which start weight each of them was or
/// where all have the same.
class HitsByWeight
{
public:
  /// @param factors See ReplicateSums::Map.
  HitsByWeight(
    const SideSums& sums, const std::vector<float>& startWeights, const LampFactors& factors)
    : Sums(sums)
    , Weights(startWeights.begin(), startWeights.end())
  {
    for (std::size_t source = 0; source < this->Weights.size() && !factors.empty(); ++source)
    {
      this->Weights[source] *= factors[source % factors.size()];
    }
    this->Largest = *std::max_element(this->Weights.begin(), this->Weights.end());
    this->AreEqual = std::all_of(this->Weights.begin(), this->Weights.end(),
      [this](double weight) { return weight == 0.0 || weight == this->Largest; });
  }

  /// Where neither is known, which is where lamps have several sources or are not kept apart.
  bool AreUnknown() const { return !this->AreEqual && this->Sums.lamps != this->Weights.size(); }

  WeightedHits At(std::size_t vertex, std::uint64_t hits) const
  {
    if (this->AreEqual)
    {
      return { static_cast<double>(hits), static_cast<double>(hits) };
    }
    WeightedHits all;
    for (std::size_t lamp = 0; lamp < this->Sums.lamps; ++lamp)
    {
      const auto n = static_cast<double>(this->Sums.hits[lamp * this->Sums.Vertices() + vertex]);
      const double weight = this->Weights[lamp] / this->Largest;
      all.sum += n * weight;
      all.squares += n * weight * weight;
    }
    return all;
  }

  /// What a hit adds to a vertex, over its start weight. It is added up in order, so that the same
  /// sums give the same bits. @param sums Weights, where a map has illuminances.
  double MeanWeight(const IlluminationMap& sums) const
  {
    double weights = 0.0;
    double hits = 0.0;
    for (std::size_t v = 0; v < sums.direct.size(); ++v)
    {
      weights += sums.Total(v);
      hits += this->At(v, sums.photonHits[v]).sum;
    }
    return weights > 0.0 ? weights / this->Largest / hits : FewHits::WithoutCompensation;
  }

  std::vector<float> CountingWeights() const
  {
    return this->AreEqual ? std::vector<float>{ static_cast<float>(this->Largest) }
                          : std::vector<float>(this->Weights.begin(), this->Weights.end());
  }
  float LargestWeight() const { return static_cast<float>(this->Largest); }

private:
  const SideSums& Sums;
  std::vector<double> Weights; ///< [source]
  double Largest = 1.0;
  bool AreEqual = true;
};

} // namespace PhotonTransport
