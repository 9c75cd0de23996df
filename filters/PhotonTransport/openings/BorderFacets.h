// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/MeshEdges.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The part of a mesh that decides where its border is: most edges have two facets that share their
/// points, which is found in much less time than what meets at places.
struct BorderFacets
{
  std::vector<std::uint32_t> facets; ///< All of those that have an edge between two such points.
  std::vector<std::uint8_t> isNear;  ///< [point] Whether a border edge may end in its place.
};

/// @return Every facet of an edge that may be in the border, and every facet in the place of such
/// an edge.
BorderFacets FacetsNearBorder(const TriangleMesh& mesh);

} // namespace PhotonTransport
