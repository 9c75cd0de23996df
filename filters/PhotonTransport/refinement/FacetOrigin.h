// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/Subdivision.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace PhotonTransport
{

/// Which part of which facet a facet of a refined mesh is.
struct FacetOrigin
{
  std::uint32_t facet;
  FacetTriangle corners;

  /// The facet's barycentric coordinates of a point that is given in those of the part.
  glm::vec3 InFacet(const glm::vec3& inPart) const
  {
    return inPart.x * this->corners[0] + inPart.y * this->corners[1] + inPart.z * this->corners[2];
  }
};

} // namespace PhotonTransport
