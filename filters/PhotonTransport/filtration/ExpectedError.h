// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/GroupStatistics.h"
#include "PhotonTransport/filtration/PhotonNoise.h"
#include "PhotonTransport/filtration/ScaleSelection.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A map before and after, and what its noise is measured by.
struct SmoothedMap
{
  const GroupColumns& before;
  const Selection& after;
  const PhotonNoise& photons;
  const std::vector<std::uint8_t>& dark; ///< Marks (1) dark regions; or empty.
};

/// Expected squared error (lx^2) of a smoothed map, noise and bias: Stein's estimate in units of
/// the photon noise of each vertex's own light.
std::vector<double> ExpectedSquaredError(
  const SmoothingGraph& graph, const SmoothedMap& map, const FiltrationMonitor& monitor);

} // namespace PhotonTransport
