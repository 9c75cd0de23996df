// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// How far two points may be apart that are meant to be one: each was rounded, as the mesh tells,
/// and computed in several steps before that.
inline double GapBetween(const glm::dvec3& a, const glm::dvec3& b, double rounding)
{
  constexpr double Steps = 16.0;
  const auto largest = [](const glm::dvec3& p) {
    return std::max({ std::fabs(p.x), std::fabs(p.y), std::fabs(p.z) });
  };
  return Steps * std::max(rounding, 0x1p-53) * std::max(largest(a), largest(b));
}

/// An end of an edge.
struct End
{
  glm::dvec3 point;
  std::uint32_t edge;
};

/// Ends of edges, sorted along each axis, so that a search can take the one along
/// which an edge has the fewest beside it.
class SortedEnds
{
public:
  explicit SortedEnds(const std::vector<End>& ends)
  {
    this->ByAxis.fill(ends);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::vector<End>& sorted = this->ByAxis[static_cast<std::size_t>(axis)];
      std::sort(sorted.begin(), sorted.end(),
        [axis](const End& a, const End& b) { return a.point[axis] < b.point[axis]; });
    }
  }

  /// Those that may be within a box, and others.
  std::pair<const End*, const End*> Near(const glm::dvec3& least, const glm::dvec3& most) const
  {
    std::pair<const End*, const End*> fewest{ nullptr, nullptr };
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<End>& sorted = this->ByAxis[static_cast<std::size_t>(axis)];
      const End *begin = sorted.data(), *end = begin + sorted.size();
      const End* first =
        std::partition_point(begin, end, [&](const End& e) { return e.point[axis] < least[axis]; });
      const End* last =
        std::partition_point(first, end, [&](const End& e) { return e.point[axis] <= most[axis]; });
      if (axis == 0 || last - first < fewest.second - fewest.first)
      {
        fewest = { first, last };
      }
    }
    return fewest;
  }

private:
  std::array<std::vector<End>, 3> ByAxis;
};

} // namespace PhotonTransport
