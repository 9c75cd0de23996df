// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/FourLanes.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace PhotonTransport
{

struct FacetBox
{
  glm::vec3 low, high;
};

/// Eight facets. Those that are missing in the last group have corners far off.
struct FacetLeaf
{
  static constexpr std::size_t Width = 8;
  static constexpr std::size_t Halves = Width / 4;

  Four corners[3][3][Halves]; ///< [corner][axis]
  Four normals[3][Halves];    ///< [axis]
  std::array<std::uint32_t, Width> facets;
  std::size_t count;
  float margin; ///< The largest of the facets, see MarginOf.
};

/// The boxes of a leaf's facets, in which all lies that may overlap them or be before their middle.
///
/// A facet that overlaps another one, or is the other side of a wall, has more than a sliver in
/// common with it as seen along the largest component of its normal, so their boxes overlap in both
/// other directions (Meet, or the boxes are the same). They may be apart along that component
/// alone. It is at least 0.54 for both facets, since they face the same or the opposite way up to
/// SameSheet and one of three components of a unit vector is at least 0.57. So boxes have a margin
/// only along components of half and more, and boxes that touch do not meet: in a wall along two
/// axes neighbours are told apart by that.
struct LeafBounds
{
  explicit LeafBounds(const FacetLeaf& leaf)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (std::size_t h = 0; h < FacetLeaf::Halves; ++h)
      {
        const Four &a = leaf.corners[0][axis][h], &b = leaf.corners[1][axis][h],
                   &c = leaf.corners[2][axis][h];
        const Four& normal = leaf.normals[axis][h];
        const Four margin = normal * normal >= 0.25f ? FourTimes(leaf.margin) : Four{};
        this->low[axis][h] = Least(a, Least(b, c)) - margin;
        this->high[axis][h] = Largest(a, Largest(b, c)) + margin;
      }
    }
  }

  /// The facets of half a leaf whose boxes meet another one.
  FourBits Meeting(const FacetBox& box, std::size_t half) const
  {
    FourBits meeting = { -1, -1, -1, -1 };
    for (int axis = 0; axis < 3; ++axis)
    {
      meeting &= this->low[axis][half] < box.high[axis];
      meeting &= this->high[axis][half] > box.low[axis];
    }
    return meeting;
  }

  /// For each facet whether its box meets another one. @return Whether any does.
  bool Meeting(const FacetBox& box, std::array<std::int32_t, FacetLeaf::Width>& meets) const
  {
    FourBits any{};
    for (std::size_t h = 0; h < FacetLeaf::Halves; ++h)
    {
      const FourBits half = this->Meeting(box, h);
      std::memcpy(&meets[4 * h], &half, sizeof half);
      any |= half;
    }
    return Any(any);
  }

  FacetBox BoxOf(std::size_t lane) const
  {
    const std::size_t half = lane / 4, i = lane % 4;
    return { { this->low[0][half][i], this->low[1][half][i], this->low[2][half][i] },
      { this->high[0][half][i], this->high[1][half][i], this->high[2][half][i] } };
  }

  Four low[3][FacetLeaf::Halves], high[3][FacetLeaf::Halves];
};

} // namespace PhotonTransport
