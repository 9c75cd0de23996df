// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Which facets may share their plane with one that faces the other way: a wall that is drawn once
/// for each side, as CAD programs export it. A ray can't tell which of the two it meets first.
/// Marks all such facets and some others. @return Empty if there are none.
/// @param groups Of the planes, see SharedPlanes.
std::vector<std::uint8_t> FacetsOfDoubleSheets(
  const std::vector<FacetPlane>& planes, const std::vector<PlaneMember>& groups);

/// Barycentric coordinates of a point that lies in a triangle, up to a gap in any direction.
std::optional<glm::vec3> Within(const glm::dvec3& point, double gap, const glm::dvec3& a,
  const glm::dvec3& b, const glm::dvec3& c);

} // namespace PhotonTransport
