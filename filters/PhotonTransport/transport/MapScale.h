// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace PhotonTransport
{

/// What turns sums of weights into lux.
struct MapScale
{
  double flux;                            ///< Of all photons as they were traced, lm.
  const std::vector<double>& areas;       ///< [vertex] m^2.
  const std::vector<float>& startWeights; ///< [source] See Emitter.
};

/// By which the light of each lamp counts in a map: its flux over the flux with which it was
/// traced. Empty: all lamps count as they were traced, and the map is made of sums of integers.
using LampFactors = std::vector<double>;

} // namespace PhotonTransport
