// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/EdgeCurves.h"
#include "PhotonTransport/refinement/MeshEdges.h"
#include "PhotonTransport/refinement/RefinedMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

class CurvedPatch;

/// Divides facets along curved patches that follow the mesh's normals, until all edges keep to the
/// limits. Facets whose edges do are left whole. The mesh stays as closed as it is: see EdgeCurves
/// and Subdivide. Points that are doubled stay so, with doubled points between them.
class Refinement
{
public:
  /// Finds the curves, which is most of the work where little is divided. Divide comes next.
  /// @param mesh Must outlive it.
  explicit Refinement(const TriangleMesh& mesh);
  /// And divides.
  Refinement(const TriangleMesh& mesh, const RefinementLimits& limits);
  Refinement(const Refinement&) = delete;
  Refinement& operator=(const Refinement&) = delete;

  /// Divides facets by limits, in place of those before.
  void Divide(const RefinementLimits& limits);
  /// How many facets there were if each was divided as finely everywhere as at its finest edge.
  /// Takes little time, however narrow the limits are. Divide comes next.
  std::uint64_t FacetsAtMost(const RefinementLimits& limits);

  /// Facets and points that Make will make.
  std::uint64_t NumberOfFacets() const { return this->FirstPart.back(); }
  std::uint64_t NumberOfPoints() const { return this->FirstInside.back(); }
  /// Whether all facets stay whole.
  bool IsTrivial() const { return this->NumberOfFacets() == this->Mesh.facets.size(); }

  /// Widens the limits until there are no more facets than `most`, or all are whole.
  /// @return The limits that serve.
  const RefinementLimits& Fit(std::uint64_t most);

  RefinedMesh Make() const;

private:
  struct FacetParts;
  CurvedPatch PatchOf(std::size_t facet) const;
  void StraightenTurned();
  void Count();
  std::uint32_t PointAt(
    std::size_t facet, const glm::vec3& barycentric, const FacetParts& parts) const;
  void AddPointsOn(std::size_t pair, RefinedMesh& fine) const;
  void AddParts(std::size_t facet, RefinedMesh& fine) const;

  TriangleMesh Mesh;
  RefinementLimits Limits;
  MeshEdges Edges;
  EdgeCurves Curves;
  std::vector<std::uint64_t> FirstPart;   ///< Of each facet, and their number.
  std::vector<std::uint64_t> FirstOnPair; ///< Point of each point pair, and their number.
  std::vector<std::uint64_t> FirstInside; ///< Point within each facet, and the number of all.
};

} // namespace PhotonTransport
