// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace PhotonTransport
{

/// How finely a map is refined where its light varies.
struct AdaptiveLimits
{
  /// By how much linear interpolation may miss the light at the middle of an edge, relative to the
  /// light there or, where that is darker, to a tenth of the map's mean; > 0.
  double tolerance = 0.05;
  std::uint64_t facets = 1'000'000; ///< At most, >= 1; a mesh that has as many itself stays whole.
};

/// Throws InvalidInput that names the value.
void Validate(const AdaptiveLimits& limits);

} // namespace PhotonTransport
