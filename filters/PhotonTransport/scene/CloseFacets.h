// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/DataRounding.h"
#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What lies in the place of a facet or nearly so, as bits.
enum CloseFacet : std::uint8_t
{
  /// A facet that faces the same way and has more than a sliver in common with it: the two may be
  /// an overlap, see ForEachOverlap.
  FacesAlike = 1,
  /// One that faces the other way: CAD programs export a wall once for each of its sides. A ray
  /// can't tell which of the two it meets first.
  FacesOpposite = 2,
  /// Any that a ray may meet that looks back at the middle of the facet, see FindThinGaps: one near
  /// it of which it is not known that it lies beside it in nearly the same plane.
  MayBeBefore = 4
};

/// For each facet its bits. No facet is missing of those that overlap others, and there may be
/// more; nor is one that has another before its middle, of those that are wide enough, see
/// Scene::MayHaveGap.
/// @param planeCells See PlaneCellsPerUnit.
std::vector<std::uint8_t> FindCloseFacets(const LargeArray<glm::vec3>& positions,
  const LargeArray<Facet>& facets, const DataRounding& rounding, float planeCells);

} // namespace PhotonTransport
