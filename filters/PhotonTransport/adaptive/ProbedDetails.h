// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/adaptive/LitMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How the facets of a mesh came about, level by level, and which divisions lead to details of the
/// light: only those are worth doing again.
class ProbedDetails
{
public:
  explicit ProbedDetails(const LitMesh& mesh)
    : DivisionOfFacet(mesh.Mesh().Facets().size(), None)
  {
  }

  /// Notes the divisions that led to the facets of edges where interpolation misses the light.
  /// @param misses [edge]
  void AddDetails(const LitMesh& mesh, const std::vector<double>& misses);

  /// Halves edges of the mesh, and notes which.
  void Halve(LitMesh& mesh, const LitMesh::Marks& marks);

  /// [sample] Whether it is at the middle of an edge that has to be halved.
  std::vector<std::uint8_t> NeededMiddles(std::size_t samples) const;

private:
  static constexpr std::uint32_t None = 0xffffffffu;
  /// A facet that was divided.
  struct Division
  {
    std::uint32_t before;                 ///< The division of which that facet came, or None.
    std::array<std::uint32_t, 3> middles; ///< Samples; LitMesh::NoSample where none is halved.
    bool isNeeded;
  };
  std::vector<Division> Divisions;
  std::vector<std::uint32_t> DivisionOfFacet; ///< From which it came, or None.
};

} // namespace PhotonTransport
