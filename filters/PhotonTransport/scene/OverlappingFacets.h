// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// Two facets that lie in one plane or nearly so, face the same way and have more than a sliver in
/// common.
struct FacetOverlap
{
  std::uint32_t first, second; ///< In ascending order.
  double area;                 ///< That they have in common.
  bool copies;                 ///< They have the same three corners.
  /// How far the second lies in front of the first where they have a part in common: least and
  /// most. Negative: behind it.
  double low, high;
  /// How far they are apart at most, in units of what rounding explains. In one plane: at most 1.
  double excess;

  double Apart() const { return std::max(-this->low, this->high); }
};

/// The facets' corners, and their planes with the groups of these.
struct FacetPlaces
{
  const LargeArray<glm::vec3>& points;
  const LargeArray<Facet>& facets;
  const std::vector<FacetPlane>& planes;
  const std::vector<PlaneMember>& groups;
  const DataRounding& rounding;
};

/// Up to this excess pairs are found that are not in one plane.
constexpr double MostExcess = 64.0;

/// Calls f for all pairs of facets that overlap; for some of them more than once. Pairs that are
/// not in one plane are found up to MostExcess, or up to 1024 where the rounding to single
/// precision would explain how far they are apart; not all of them are found.
///
/// A floor of many facets is looked through in linear time: facets that are joined along all their
/// edges can't overlap each other unless others do at the outline, see Outline.
void ForEachOverlap(const FacetPlaces& places, const std::function<void(const FacetOverlap&)>& f);

} // namespace PhotonTransport
