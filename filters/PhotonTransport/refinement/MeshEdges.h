// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/SortedEnds.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What a refinement needs of a triangulated surface. The arrays must outlive it.
struct TriangleMesh
{
  const std::vector<glm::dvec3>& points;  ///< Finite where a facet uses them.
  const std::vector<glm::dvec3>& normals; ///< One a point, any length; or empty.
  const std::vector<glm::uvec3>& facets;  ///< Point indices.
  double rounding = 0.0;                  ///< See Surface::rounding.
};

/// The side of a facet that is opposite to one of its corners.
struct FacetEdge
{
  std::uint32_t facet;
  std::uint32_t side;
};

/// A side that runs between two points of the mesh's list.
struct PointPair
{
  std::uint32_t from, to; ///< In the direction of its edge.
  std::uint32_t edge;
};

/// The edges of a mesh. An edge is a piece of space: facets share it where their corners have the
/// same coordinates, even if they have points of their own there, as VTK's filters make them
/// at sharp edges. So do facets at the border of parts that were made apart, whose corners differ
/// by rounding. A point pair has the points, too; an edge has several of them where points are
/// doubled.
class MeshEdges
{
public:
  explicit MeshEdges(const TriangleMesh& mesh);

  std::size_t Number() const { return this->FirstSides.size() - 1; }
  const std::vector<PointPair>& Pairs() const { return this->PointPairs; }
  std::uint32_t PairOf(std::size_t facet, std::size_t side) const
  {
    return this->PairOfSide[3 * facet + side];
  }
  std::uint32_t EdgeOf(std::size_t facet, std::size_t side) const
  {
    return this->PointPairs[this->PairOf(facet, side)].edge;
  }

  const PointPair& FirstPair(std::size_t edge) const
  {
    return this->PointPairs[this->PairOfSide[this->Sides[this->FirstSides[edge]]]];
  }

  /// Calls f(FacetEdge) for each facet of an edge, those of one point pair after each other.
  template <class Function>
  void ForEachSide(std::size_t edge, const Function& f) const
  {
    for (std::size_t i = this->FirstSides[edge]; i < this->FirstSides[edge + 1]; ++i)
    {
      f(FacetEdge{ this->Sides[i] / 3, this->Sides[i] % 3 });
    }
  }
  std::size_t NumberOfFacets(std::size_t edge) const
  {
    return this->FirstSides[edge + 1] - this->FirstSides[edge];
  }

  /// Both ends of each edge that only one facet has, after each other.
  std::vector<End> OpenEnds(const TriangleMesh& mesh) const;

private:
  void Build(const TriangleMesh& mesh, const std::vector<std::uint32_t>& places);
  bool JoinBorders(const TriangleMesh& mesh, std::vector<std::uint32_t>& places) const;

  std::vector<PointPair> PointPairs;
  std::vector<std::uint32_t> PairOfSide; ///< By 3 * facet + side.
  std::vector<std::uint32_t> Sides;      ///< 3 * facet + side, sorted by edge, then by pair.
  std::vector<std::uint32_t> FirstSides; ///< Of each edge in Sides, and their number.
};

} // namespace PhotonTransport
