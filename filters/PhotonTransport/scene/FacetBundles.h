// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Whether two planes that are near each other count as one.
inline bool FaceTheSameWay(
  const std::vector<FacetPlane>& planes, std::uint32_t facet, std::uint32_t other)
{
  return glm::dot(planes[facet].normal, planes[other].normal) > SameSheet;
}

/// Facets of a group that face about the same way.
struct Bundle
{
  glm::vec3 normal;
  std::vector<std::uint32_t> facets;
};

/// Bundles of the facets in a group. Facets that face the same way are together in at least one
/// bundle. Most groups in which no two facets do have no bundle.
std::vector<Bundle> BundlesOf(
  const std::vector<FacetPlane>& planes, const PlaneMember* first, const PlaneMember* last);

} // namespace PhotonTransport
