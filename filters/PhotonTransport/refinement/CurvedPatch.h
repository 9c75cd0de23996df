// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/EdgeCurves.h"
#include "PhotonTransport/refinement/Subdivision.h"

#include <array>

namespace PhotonTransport
{

/// The quadratic Bezier triangle over a facet: x = u p0 + v p1 + w p2 + 4 (v w o0 + w u o1 + u v
/// o2) with the barycentric coordinates u, v, w and the offsets o of the edges' curves.
class CurvedPatch
{
public:
  /// @param limits Those by which the curves were divided.
  CurvedPatch(const TriangleMesh& mesh, const MeshEdges& edges, const EdgeCurves& curves,
    const RefinementLimits& limits, std::size_t facet);

  bool IsWhole() const
  {
    return this->Halvings[0] == 0 && this->Halvings[1] == 0 && this->Halvings[2] == 0;
  }

  /// The same bits for all facets of an edge, and for all facets that have the same corners.
  /// @param barycentric Of the facet.
  glm::dvec3 At(const glm::vec3& barycentric) const;

  /// Calls keep(FacetTriangle) for each part of the facet.
  template <class Keep>
  void Subdivide(const Keep& keep) const
  {
    if (this->IsWhole())
    {
      keep(WholeFacet);
      return;
    }
    PhotonTransport::Subdivide(
      WholeFacet, [this](const glm::vec3& p, const glm::vec3& q) { return this->Halves(p, q); },
      [&](const FacetTriangle& part) { keep(this->InFacet(part)); });
  }

  /// Whether the patch is curved, and a part of it faces away from the facet. A facet that is too
  /// narrow to face any way counts as one.
  bool Turns() const;

private:
  // The corners in here are in the order of their coordinates, whatever their order in the facet:
  // so two sheets of a wall, of which one faces the other way, have their parts in the same places.
  bool IsOrdered() const { return (this->Order[0] + 1) % 3 == this->Order[1]; }
  FacetTriangle InFacet(const FacetTriangle& part) const;
  glm::dvec3 AtOrdered(const glm::vec3& barycentric) const;
  /// Whether the edge between two points of the patch is to be halved. On an edge of the facet this
  /// is a matter of the edge alone.
  bool Halves(const glm::vec3& p, const glm::vec3& q) const;

  RefinementLimits Limits;
  std::array<int, 3> Order; ///< Of each corner: its place in the facet.
  std::array<glm::dvec3, 3> Corners;
  std::array<glm::dvec3, 3> Offsets; ///< Edge i is opposite to corner i.
  std::array<int, 3> Halvings;
  std::array<double, 3> Turns2; ///< Squared difference of the unit normals at the ends of edge i.
  std::array<std::size_t, 3> From; ///< The corner where edge i begins.
};

} // namespace PhotonTransport
