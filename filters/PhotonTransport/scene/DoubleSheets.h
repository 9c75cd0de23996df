// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Two sheets this close, relative to the reach of a point (Scene::Reach), are in one place: a
/// ray's distance to them is rounded by as much.
constexpr float SheetGap = 0x1p-20f;

/// A facet's plane: any of its points, and its unit normal.
struct FacetPlane
{
  glm::vec3 point;
  glm::vec3 normal;
};

/// Which facets may share their plane with one that faces the other way: a wall that is drawn once
/// for each side, as CAD programs export it. A ray can't tell which of the two it meets first.
/// Marks all such facets and some others. @return Empty if there are none.
std::vector<std::uint8_t> FacetsOfDoubleSheets(const std::vector<FacetPlane>& planes);

/// Barycentric coordinates of a point that lies in a triangle, up to a gap in any direction.
std::optional<glm::vec3> Within(const glm::dvec3& point, double gap, const glm::dvec3& a,
  const glm::dvec3& b, const glm::dvec3& c);

} // namespace PhotonTransport
