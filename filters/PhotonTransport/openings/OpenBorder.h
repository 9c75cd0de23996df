// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/MeshEdges.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A straight piece of a surface's border, between two nodes.
struct BorderSegment
{
  std::uint32_t from, to; ///< Nodes.
  std::uint32_t facet;    ///< The one that ends there.
};

/// Where a surface ends: the pieces of space along which there is one facet.
struct OpenBorder
{
  std::vector<glm::dvec3> nodes; ///< Points that differ by rounding are one.
  std::vector<BorderSegment> segments;
};

/// Finds the border. Facets meet even if their corners differ by rounding, or if one has an edge
/// along several edges of the others (T-junctions). Facets with the same corners count as one, so
/// that walls which are drawn from both sides end where their two sheets do.
OpenBorder FindOpenBorder(const TriangleMesh& mesh);

} // namespace PhotonTransport
