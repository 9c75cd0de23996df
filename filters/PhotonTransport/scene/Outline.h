// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A number for each place, the same for points in the same place. Sums of them are different.
std::vector<std::uint64_t> NumbersOfPlaces(const LargeArray<glm::vec3>& points);

/// Finds which facets lie at the outline of what they cover. The facets are in one plane and face
/// about the same way.
///
/// The outline consists of the facets' edges, counter-clockwise, without those that are there in
/// both directions. It winds round a point as many times as facets cover the point. Where two
/// facets overlap, pieces of the outline bound their common area, and a facet with such an edge
/// overlaps another one there. So it is enough to look at the facets at the outline.
class Outline
{
public:
  /// @param numbers Of the points, see NumbersOfPlaces. @param facets Of which there are triangles.
  /// Both must outlive this.
  Outline(const std::vector<std::uint64_t>& numbers, const LargeArray<Facet>& facets)
    : Numbers(numbers)
    , Facets(facets)
  {
  }

  /// Indices of triangles with two corners at the outline or more.
  std::vector<std::uint32_t> TrianglesAt(const std::vector<PlaneTriangle>& triangles);

private:
  void AddEdges(const std::vector<PlaneTriangle>& triangles);
  void JoinPoints(const std::vector<PlaneTriangle>& triangles);

  const std::vector<std::uint64_t>& Numbers; ///< Of the points.
  const LargeArray<Facet>& Facets;
  std::vector<std::uint64_t> Sums; ///< Of the points; all 0 between calls.
};

} // namespace PhotonTransport
