// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
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

} // namespace PhotonTransport
