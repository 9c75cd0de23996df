// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace PhotonTransport
{

/// The standard error of a sum of few hits, where the spread of replicates says little: it is 0
/// where nothing came, and of one or two hits it hardly knows more than how near to the vertex they
/// fell.
///
/// How many hits are due, their number n tells, if every number was as likely before (the posterior
/// of a Poisson process): their variance is n + 1, and for 3 standard errors to hold what 3
/// standard errors of 8 replicates do, 98 %, it takes n + 2. A hit adds its barycentric coordinate
/// times a compensating factor; hits spread over a facet have a mean square coordinate of 1/6 for a
/// mean of 1/3, which is where MeanSquare comes from.
class FewHits
{
public:
  /// @param meanWeight Of a hit, over all vertices; 1/3 without compensation.
  /// @param replicates Whether there are some that can tell; or else hits have to do.
  FewHits(double meanWeight, bool replicates)
    : MeanSquareWeight(MeanSquare * meanWeight * meanWeight)
    , Replicates(replicates)
  {
  }

  /// Of the sum of weights. @param spread What replicates say: from 30 hits on that is all, below
  /// it counts if it is more.
  double StandardError(double spread, std::uint64_t hits) const
  {
    const auto n = static_cast<double>(hits);
    const double trust = this->Replicates ? std::clamp((Many - n) / (Many - Few), 0.0, 1.0) : 1.0;
    return std::max(spread, std::sqrt(trust * (n + Prior) * this->MeanSquareWeight));
  }

private:
  static constexpr double MeanSquare = 1.5; ///< Over the squared mean.
  static constexpr double Prior = 2.0;      ///< Hits.
  static constexpr double Few = 9.0;        ///< Up to so many count in full.
  static constexpr double Many = 30.0;

  double MeanSquareWeight;
  bool Replicates;
};

} // namespace PhotonTransport
