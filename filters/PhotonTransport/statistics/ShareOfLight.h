// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// What part of some light was found in one place, as photons tell it.
struct ShareOfLight
{
  double part = 0.0;  ///< lm
  double whole = 0.0; ///< lm
  /// lm^2: the squared flux of each photon, added up. Few photons of much light tell little.
  double squaredPart = 0.0;
  double squaredWhole = 0.0;

  /// 0 where there is no light.
  double Value() const { return this->whole > 0.0 ? this->part / this->whole : 0.0; }

  /// Whether chance alone hardly makes the share exceed a threshold: the part exceeds that share of
  /// the whole by three standard errors. That of the difference is the larger one of what was found
  /// and of what is expected where the share is just the threshold, since few photons show little
  /// of it (by the second, the score test of Wilson, "Probable Inference, the Law of Succession,
  /// and Statistical Inference", 1927). @param threshold In [0, 1].
  bool SurelyExceeds(double threshold) const
  {
    const double rest = 1.0 - threshold;
    const double found = rest * rest * this->squaredPart +
      threshold * threshold * (this->squaredWhole - this->squaredPart);
    const double variance = std::max(found, threshold * rest * this->squaredWhole);
    const double excess = this->part - threshold * this->whole;
    return excess > 0.0 && excess > 3.0 * std::sqrt(variance);
  }
};

} // namespace PhotonTransport
