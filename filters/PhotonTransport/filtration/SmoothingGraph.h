// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/VertexOrder.h"
#include "PhotonTransport/geometry/FacetRings.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

class RingEdges;

/// Which vertices exchange light when a map is smoothed, and how strongly: the cotangent Laplacian
/// of the surface, cut along creases, non-manifold edges and rims, so that smooth patches are its
/// connected components. With conductances c and vertex areas A, (L x)_v = sum_u c_vu (x_v - x_u).
/// c grows with the areas, so that the light of one vertex spreads over as many vertices in a fine
/// region as in a coarse one.
class SmoothingGraph
{
public:
  struct Edge
  {
    std::uint32_t neighbour;
    float conductance; ///< > 0; the same from both ends. In units of the mean vertex area.
  };

  /// No eigenvalue of A^-1 L is larger: where a row is too stiff its conductances are lowered.
  static constexpr float LargestEigenvalue = 8.0f;

  /// Throws InvalidInput for a facet's point that is not finite. @param points Any unit. @param
  /// facets Point indices, all in range. @param creaseAngle Radians between the facets of an edge
  /// above which light does not cross it.
  SmoothingGraph(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets,
    double creaseAngle);

  /// The same graph with its vertices numbered by their places in an order.
  SmoothingGraph(const SmoothingGraph& graph, const VertexOrder& order);

  /// An order in which neighbours are near each other, whatever order the mesh has: that of a
  /// breadth-first search (Cuthill and McKee, 1969). Memory, not arithmetic, is what smoothing
  /// waits for.
  VertexOrder BreadthFirstOrder() const;

  std::size_t Vertices() const { return this->Areas.size(); }
  /// A_v, a third of the facets around; 0 where there are none. Square of the points' unit.
  const std::vector<double>& VertexAreas() const { return this->Areas; }
  /// Smooth patch of each vertex, [0, Patches()).
  const std::vector<std::uint32_t>& PatchOfVertex() const { return this->Patch; }
  std::size_t Patches() const { return this->PatchCount; }
  /// Whether light spreads from the vertex to one side only: it is on a rim, or beside a crease.
  bool IsAtBorder(std::size_t vertex) const { return this->AtBorder[vertex] != 0; }

  /// Mean vertex area over that of the vertex; 0 for a vertex without an area.
  float InverseArea(std::size_t vertex) const { return this->InverseAreas[vertex]; }

  Range<Edge> At(std::size_t vertex) const
  {
    return { this->Edges.data() + this->First[vertex],
      this->Edges.data() + this->First[vertex + 1] };
  }

  /// Cuts the edges between marked (1) and other (0) vertices. Patches stay as they are.
  void CutAround(const std::vector<std::uint8_t>& marked);

private:
  void LimitEigenvalues();
  void FindPatches();

  void FindAreas(const RingEdges& rings);
  void Connect(const RingEdges& rings);

  std::vector<double> Areas;
  std::vector<float> InverseAreas;
  std::vector<std::uint64_t> First; ///< Of each vertex in Edges, and their number.
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> Patch;
  std::vector<std::uint8_t> AtBorder;
  std::size_t PatchCount = 0;
};

} // namespace PhotonTransport
