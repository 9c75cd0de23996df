// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

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

} // namespace PhotonTransport
