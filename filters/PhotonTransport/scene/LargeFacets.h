// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/FacetParts.h"
#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// Embree's error at a facet grows with the facet's extent. Facets that are large for their
/// distance from the origin, where coordinates are fine, are traced in parts that are not.
/// @param leastReach See Scene::Reach. Grows until the parts are some thousand, or an eighth of the
/// facets, at most.
std::vector<FacetPart> PartsOfLargeFacets(
  const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets, float& leastReach);

} // namespace PhotonTransport
