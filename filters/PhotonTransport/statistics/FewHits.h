// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

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
class FewHits
{
public:
  /// @param meanWeight The mean weight of a hit, over all vertices; 1/3 without compensation.
  /// @param replicates Whether there are replicates that tell a spread. If not, the number of hits
  /// counts in full, however many there are.
  FewHits(double meanWeight, bool replicates)
    : MeanSquareWeight(MeanSquare * meanWeight * meanWeight)
    , Replicates(replicates)
  {
  }

  /// The standard error of the sum of weights: the spread of the replicates, but at least what the
  /// number of hits says. That counts in full up to 9 hits, less and less beyond, and not at all
  /// from 30 on. @param spread The standard error by the replicates.
  double StandardError(double spread, std::uint64_t hits) const
  {
    const auto n = static_cast<double>(hits);
    const double trust = this->Replicates ? std::clamp((Many - n) / (Many - Few), 0.0, 1.0) : 1.0;
    return std::max(spread, std::sqrt(trust * (n + Prior) * this->MeanSquareWeight));
  }

private:
  static constexpr double MeanSquare = 1.5; ///< Of the coordinates, over their squared mean.
  static constexpr double Prior = 2.0;      ///< Hits.
  static constexpr double Few = 9.0;        ///< Up to so many count in full.
  static constexpr double Many = 30.0;

  double MeanSquareWeight;
  bool Replicates;
};

} // namespace PhotonTransport
