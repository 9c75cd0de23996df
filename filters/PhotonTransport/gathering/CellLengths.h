// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace PhotonTransport
{

class Scene;

/// How long the cells of each facet may be (see FacetCells), scene units. Light varies over a facet
/// at the scale of its distance to what it sees, so cells are a share of the mean length of rays
/// that leave the facet, on the side where that is shorter, or on the front.
std::vector<float> CellLengths(const Scene& scene, bool bothSides = true);

} // namespace PhotonTransport
