// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/MeshEdges.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The edges of a single facet that have a point of another such edge between their ends, and those
/// that run along them: where facets of unlike sizes meet, one edge lies beside several (a
/// T-junction). If one of them curved and the others did not, or not alike, a gap would open.
/// A point is on an edge if it is as near as the rounding of the points can tell.
std::vector<std::uint32_t> EdgesWithPointsOnThem(const TriangleMesh& mesh, const MeshEdges& edges);

} // namespace PhotonTransport
