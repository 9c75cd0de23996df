// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/GroupStatistics.h"
#include "PhotonTransport/filtration/ScaleSelection.h"

#include <vector>

namespace PhotonTransport
{

/// The square (lx^2) of what smoothing may have moved across an edge of the light, such as the rim
/// of a shadow, at each vertex. Means of Stein's estimate over a neighbourhood do not show the one
/// row of vertices on either side that it changes most. The slope that smoothing has left there
/// does: where kernels are narrow, steep light was steeper before.
/// @param units [vertex] What the noise of a vertex is in proportion to, lx^2; see ExpectedError.
std::vector<double> SquaredEdgeBias(const SmoothingGraph& graph, const GroupColumns& before,
  const Selection& after, const std::vector<double>& units);

} // namespace PhotonTransport
