// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/SmoothingGraph.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Marks (1) the vertices that light certainly does not reach: connected vertices without a photon
/// whose surroundings are so bright that photons would have come. The expected number of photons m,
/// at the density of the lit vertices around the region, makes a region that is dark by chance as
/// probable as exp(-m); it must be beyond chance for every region that could have been found.
/// @param hits [vertex] Photons on the facets around.
/// @return Empty if there is no such region.
std::vector<std::uint8_t> FindDarkRegions(
  const SmoothingGraph& graph, const std::vector<double>& hits);

} // namespace PhotonTransport
