// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/FacetRings.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// An edge from a vertex to a neighbour.
struct RingEdge
{
  std::uint32_t neighbour;
  float weight; ///< Half the sum of the cotangents opposite the edge, within [0.2, 1].
  bool crease;  ///< Folded sharply, or on more than two facets.
  bool rim;     ///< On one facet.
};

/// What light may cross a vertex when a map is smoothed.
enum class Crossing : std::uint8_t
{
  Free,
  AlongCrease, ///< Only light of the crease that the vertex lies on.
  None         ///< The end or a fork of a crease, or a point where surfaces merely touch.
};

/// The edges around each vertex of a triangulated surface, made on demand.
class RingEdges
{
public:
  /// The arguments must outlive this; see SmoothingGraph.
  RingEdges(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets,
    double creaseAngle);

  /// Replaces `edges` by those at a vertex, each edge once, in the order of the neighbours.
  void At(std::uint32_t vertex, std::vector<RingEdge>& edges) const;
  /// @param edges Those at the vertex.
  Crossing CrossingAt(std::uint32_t vertex, const std::vector<RingEdge>& edges) const;
  /// A third of the area of the facets around.
  double AreaOf(std::uint32_t vertex) const;
  /// Where the vertex's own part of an array with two edges a facet around each vertex begins.
  std::size_t FirstPlace(std::uint32_t vertex) const;

private:
  struct Side;
  void CollectSides(std::uint32_t vertex, std::vector<Side>& sides) const;
  bool IsCrease(const Side* first, const Side* last) const;
  RingEdge MakeEdge(const Side* first, const Side* last) const;
  std::size_t Fans(std::uint32_t vertex) const;

  const std::vector<glm::dvec3>& Points;
  const std::vector<glm::uvec3>& Facets;
  FacetRings Rings;
  std::vector<glm::vec3> Normals; ///< Of the facets, unit; zero where there is no area.
  float CosCrease;
};

} // namespace PhotonTransport
