// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/OpenBorder.h"
#include "PhotonTransport/refinement/MeshEdges.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A flat polygon that a surface's border encloses.
struct FlatLoop
{
  std::vector<glm::dvec3> corners;   ///< Counter-clockwise about the normal.
  glm::dvec3 normal;                 ///< Unit.
  std::vector<std::uint32_t> facets; ///< Those that end at it.
};

/// Finds the flat loops of a border: holes of walls, and rims of surfaces that are not flat. Nodes
/// lie in a plane if they are within a thousandth of the loop's extent. Where the border does not
/// close in a plane, since it goes on elsewhere (a door whose threshold other facets close), a
/// straight line from end to end closes the loop. Polygons in which facets at the border lie, as in
/// the rim of a flat ground, are none; nor are cracks, a thousand times as long as wide.
std::vector<FlatLoop> FindFlatLoops(const TriangleMesh& mesh, const OpenBorder& border);

} // namespace PhotonTransport
