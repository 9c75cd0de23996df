// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/PlaneTriangle.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Which of some facets in a plane that face about the same way lie at the outline of what they
/// cover.
///
/// How many facets cover a point is the number of times that the outline winds round it, the
/// outline being all edges, counter-clockwise, less those that are there in both directions. Where
/// two facets overlap, their common area is bounded by pieces of the outline; the facet that has
/// this edge overlaps another one there. So it is enough to look at the facets at the outline.
class Outline
{
public:
  /// @param points, facets Of which there are triangles; must outlive this.
  Outline(const std::vector<glm::vec3>& points, const std::vector<glm::uvec3>& facets)
    : Points(points)
    , Facets(facets)
  {
  }

  /// Indices of triangles with two corners at the outline or more.
  std::vector<std::uint32_t> TrianglesAt(const std::vector<PlaneTriangle>& triangles);

private:
  void AddEdges(const std::vector<PlaneTriangle>& triangles);
  void JoinPoints(const std::vector<PlaneTriangle>& triangles);

  const std::vector<glm::vec3>& Points;
  const std::vector<glm::uvec3>& Facets;
  std::vector<std::uint64_t> Numbers; ///< Of the points.
  std::vector<std::uint64_t> Sums;    ///< Of the points; all 0 between calls.
};

} // namespace PhotonTransport
