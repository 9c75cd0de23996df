// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Marks (1) the facets that may share their plane with a facet that faces the other way: CAD
/// programs export a wall once for each of its sides. A ray can't tell which of the two it meets
/// first. All such facets are marked, and some others. @return [facet], or empty if there are none.
/// @param groups Of the planes, see SharedPlanes.
std::vector<std::uint8_t> FacetsOfDoubleSheets(
  const std::vector<FacetPlane>& planes, const std::vector<PlaneMember>& groups);

/// Barycentric coordinates of a point in a triangle, each in [0, 1]; nothing for a point that is
/// farther than the gap from its plane or beyond one of its edges.
std::optional<glm::vec3> Within(const glm::dvec3& point, double gap, const glm::dvec3& a,
  const glm::dvec3& b, const glm::dvec3& c);

} // namespace PhotonTransport
