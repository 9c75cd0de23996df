// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace PhotonTransport
{

using TriangleCorners = std::array<glm::dvec3, 3>;

/// Divides a flat polygon into triangles whose corners are its own. Corners on a straight line are
/// left out first, up to 1e-7 of the polygon's extent.
/// @param corners Counter-clockwise about the normal. The polygon may touch itself, as if a
/// corridor without width joined two parts of it, but must not cross itself.
/// @return Counter-clockwise triangles with an area; none if the polygon crosses itself.
std::vector<TriangleCorners> TrianglesOfPolygon(
  const std::vector<glm::dvec3>& corners, const glm::dvec3& normal);

} // namespace PhotonTransport
