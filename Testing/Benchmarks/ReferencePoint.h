// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// How far rays of the reference start above a facet, in the scene's length: some hundred times the
/// rounding of a coordinate.
constexpr double ReferenceLift = 4e-6;

/// A place beside a vertex, on a facet that the vertex belongs to, where rays start.
struct ReferenceStart
{
  glm::dvec3 origin; ///< In the scene's coordinates.
  glm::dvec3 normal; ///< Unit, of the facet's front.
};

/// A vertex whose front receives light.
struct ReferencePoint
{
  glm::dvec3 normal; ///< Unit: the vertex normal, by whose cosine light counts.
  /// One for each direction that facets around the vertex face. A start is pulled into these
  /// facets by about a thousandth of an edge. At the edges of a room the vertex itself lies in the
  /// neighbour's plane, and its rays would leave the room.
  std::vector<ReferenceStart> starts;
};

/// All vertices of a map, ready to receive light. A vertex without a facet has no starts.
std::vector<ReferencePoint> ReferencePoints(const PhotonTransport::Scene& scene);
