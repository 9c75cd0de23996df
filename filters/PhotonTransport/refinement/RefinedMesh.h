// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/FacetOrigin.h"

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// A finer mesh over a given one.
struct RefinedMesh
{
  std::vector<glm::dvec3> points;   ///< The given ones first, unmoved.
  std::vector<glm::uvec3> facets;   ///< Parts of a facet follow each other, in the facets' order.
  std::vector<FacetOrigin> origins; ///< One a facet.
};

} // namespace PhotonTransport
