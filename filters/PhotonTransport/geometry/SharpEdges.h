// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Marks the points (1, else 0) that lie on an edge at which two facets meet at more than an angle.
/// Of an edge with more than two facets, each is compared with the first one in the list.
/// @param normals Of the facets, unit, on their fronts; zero for a facet that does not count.
/// @param cosine Of the angle between two normals, in [-1, 1].
std::vector<std::uint8_t> PointsOnSharpEdges(std::size_t points,
  const std::vector<glm::uvec3>& facets, const std::vector<glm::vec3>& normals, float cosine);

} // namespace PhotonTransport
