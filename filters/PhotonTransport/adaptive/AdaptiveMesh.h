// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/FacetOrigin.h"
#include "PhotonTransport/refinement/MeshEdges.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A mesh whose edges are halved level by level, each by itself, so that it stays as closed as it
/// was. A facet of which an edge is halved has its longest edge halved, too: angles stay above half
/// of the least one (Rivara, "Algorithms for refining triangular grids suitable for adaptive and
/// multigrid techniques", 1984).
class AdaptiveMesh
{
public:
  /// [edge] 1 if it is to be halved.
  using Marks = std::vector<std::uint8_t>;

  /// @param mesh Whose facets are whole at first. It is copied.
  explicit AdaptiveMesh(const TriangleMesh& mesh);

  /// The given ones first, unmoved.
  const std::vector<glm::dvec3>& Points() const { return this->AllPoints; }
  /// Parts of a given facet follow each other, in the order of the given ones.
  const std::vector<glm::uvec3>& Facets() const { return this->AllFacets; }
  const std::vector<FacetOrigin>& Origins() const { return this->AllOrigins; }
  const MeshEdges& Edges() const { return this->AllEdges; }
  double Length(std::size_t edge) const { return this->Lengths[edge]; } ///< In the data's unit.

  /// Marks the longest edges of facets with a marked edge.
  void Close(Marks& halved) const;
  std::uint64_t FacetsAfter(const Marks& halved) const;
  /// What halving has made of the mesh.
  struct Halved
  {
    std::vector<PointPair> pairs;       ///< Of points before, one for each new point in order.
    std::vector<std::uint32_t> parents; ///< [facet] The one before of which it is a part.
  };
  /// @param marks Closed.
  Halved Halve(const Marks& marks);

private:
  struct Dividing;
  void MeasureEdges();
  int LongestSide(std::size_t facet) const;
  void AddParts(std::size_t facet, const Marks& halved, Dividing& dividing) const;

  std::vector<glm::dvec3> AllPoints;
  std::vector<glm::dvec3> NoNormals;
  std::vector<glm::uvec3> AllFacets;
  std::vector<FacetOrigin> AllOrigins;
  double Rounding;
  MeshEdges AllEdges;
  std::vector<double> Lengths; ///< [edge]
};

} // namespace PhotonTransport
