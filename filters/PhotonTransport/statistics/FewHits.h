// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The standard error of a sum of few hits. The spread of replicates says little there: it is 0
/// where no hit came, and for one or two hits it depends mostly on how near to the vertex they
/// fell.
///
/// The number n of hits tells how many are to be expected. If every expected number was equally
/// likely before, it has the variance n + 1 (the posterior of a Poisson process). Here n + 2 is
/// used, so that 3 standard errors hold the true value as often as those of 8 replicates do, 98 %.
/// A hit adds its barycentric coordinate times a compensating factor. The coordinates of hits that
/// are spread over a facet have the mean 1/3 and the mean square 1/6, which gives MeanSquare.
///
/// Where photons start with different weights, hits are taken to have the least of them with which
/// they could add up to the sum; it decides the error. If that is not the least of all, no more
/// hits can have had it than make up the sum, and only these count. Without a hit nothing tells
/// which photons would come, and the largest start weight counts.
class FewHits
{
public:
  /// @param meanWeight The mean weight of a hit, over all vertices; 1/3 without compensation.
  /// @param replicates Whether there are replicates that tell a spread. If not, the number of hits
  /// counts in full, however many there are.
  /// @param startWeights Of photons, those that are 0 do not count.
  FewHits(double meanWeight, bool replicates, const std::vector<float>& startWeights = { 1.0f })
    : StartWeights(startWeights.begin(), startWeights.end())
    , MeanWeight(meanWeight)
    , Replicates(replicates)
  {
    std::sort(this->StartWeights.begin(), this->StartWeights.end());
    this->StartWeights.erase(
      std::unique(this->StartWeights.begin(), this->StartWeights.end()), this->StartWeights.end());
    if (this->StartWeights.size() > 1 && this->StartWeights.front() == 0.0)
    {
      this->StartWeights.erase(this->StartWeights.begin());
    }
    if (this->StartWeights.size() > 1)
    {
      this->MeanWeight = WithoutCompensation; // the mean mixes start weights
    }
  }

  /// The standard error of the sum of weights: the spread of the replicates, but at least what the
  /// number of hits says. That counts in full up to 9 hits, less and less beyond, and not at all
  /// from 30 on. @param spread The standard error by the replicates. @param sum Of the weights.
  double StandardError(double spread, std::uint64_t hits, double sum = 0.0) const
  {
    auto n = static_cast<double>(hits);
    auto start = this->StartWeights.begin();
    while (start + 1 != this->StartWeights.end() && (hits == 0 || n * *start < sum))
    {
      ++start;
    }
    const double weight = this->MeanWeight * *start;
    n = start == this->StartWeights.begin() ? n : std::min(n, sum / weight);
    return this->AtLeast(spread, n, n, weight);
  }

  /// The same where it is known how many hits came with which start weight. The hits that might
  /// have come are taken to have the largest one, so only hits that add up to as much tell that
  /// the spread is known. @param weighted The sum of the hits' start weights over the largest one.
  /// @param squares The sum of the squares of the same.
  double StandardErrorOf(double spread, double weighted, double squares) const
  {
    return this->AtLeast(spread, weighted, squares, this->MeanWeight * this->StartWeights.back());
  }

  static constexpr double WithoutCompensation = 1.0 / 3.0; ///< The mean weight.

private:
  double AtLeast(double spread, double hits, double squares, double weight) const
  {
    const double trust =
      this->Replicates ? std::clamp((Many - hits) / (Many - Few), 0.0, 1.0) : 1.0;
    const double meanSquareWeight = MeanSquare * weight * weight;
    return std::max(spread, std::sqrt(trust * (squares + Prior) * meanSquareWeight));
  }

  static constexpr double MeanSquare = 1.5; ///< Of the coordinates, over their squared mean.
  static constexpr double Prior = 2.0;      ///< Hits.
  static constexpr double Few = 9.0;        ///< Up to so many count in full.
  static constexpr double Many = 30.0;

  std::vector<double> StartWeights; ///< Rising, each once; never empty.
  double MeanWeight;
  bool Replicates;
};

} // namespace PhotonTransport
