// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/FacetOrigin.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// A part of a flat facet.
struct FacetPart : FacetOrigin
{
  std::array<glm::vec3, 3> positions; ///< Of the corners, each rounded once.
};

/// The point that has these barycentric coordinates. The products are exact, and on an edge only
/// two of them are not zero. So both facets of an edge get the same bits for a point of it,
/// whatever the order of their corners.
glm::vec3 PositionOf(const glm::vec3& barycentric, const std::array<glm::vec3, 3>& corners);

/// Whether the edge between two points is to be halved.
using HalvesEdge = std::function<bool(const glm::vec3&, const glm::vec3&)>;

/// Divides a facet, see Subdivide. Adds no part if no edge of the facet is halved.
/// @param halves Depends on the two points alone. Asked again for the parts of an edge, 20 times
/// at most.
void AppendParts(std::uint32_t facet, const std::array<glm::vec3, 3>& corners,
  const HalvesEdge& halves, std::vector<FacetPart>& parts);

} // namespace PhotonTransport
