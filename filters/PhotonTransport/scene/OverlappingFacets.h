// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// Two facets that lie in one plane, face the same way and have more than a sliver in common.
struct FacetOverlap
{
  std::uint32_t first, second; ///< In ascending order.
  double area;                 ///< That they have in common.
  bool copies;                 ///< They have the same three corners.
};

/// The facets' corners, and their planes with the groups of these.
struct FacetPlaces
{
  const std::vector<glm::vec3>& points;
  const std::vector<glm::uvec3>& facets;
  const std::vector<FacetPlane>& planes;
  const std::vector<PlaneMember>& groups;
};

/// Calls f for all pairs of facets that overlap; for some of them more than once.
///
/// A floor of many facets is looked through in linear time: facets that are joined along all their
/// edges can't overlap each other unless others do at the outline, see Outline.
void ForEachOverlap(const FacetPlaces& places, const std::function<void(const FacetOverlap&)>& f);

} // namespace PhotonTransport
