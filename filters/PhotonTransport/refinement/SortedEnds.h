// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// Ends of edges as a k-d tree: the middle one of a range has those before it on one side along
/// an axis and those after it on the other, and so have both parts. A search takes time by what it
/// finds, however many ends there are elsewhere.
class SortedEnds
{
public:
  explicit SortedEnds(const std::vector<End>& ends)
    : Ends(ends)
    , Axes(ends.size())
  {
    this->Sort(0, this->Ends.size());
  }

  /// Calls f(End) for each end within a box.
  template <class Function>
  void ForEachWithin(const glm::dvec3& least, const glm::dvec3& most, const Function& f) const
  {
    this->Search(0, this->Ends.size(), least, most, f);
  }

private:
  /// The axis along which ends of a range, of which there is one, lie farthest apart.
  int WidestAxis(std::size_t first, std::size_t last) const
  {
    glm::dvec3 least = this->Ends[first].point, most = least;
    for (std::size_t i = first; i < last; ++i)
    {
      least = glm::min(least, this->Ends[i].point);
      most = glm::max(most, this->Ends[i].point);
    }
    const glm::dvec3 extent = most - least;
    const int ofTwo = extent.y > extent.x ? 1 : 0;
    return extent.z > extent[ofTwo] ? 2 : ofTwo;
  }

  void Sort(std::size_t first, std::size_t last)
  {
    if (last - first < 2)
    {
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    const int axis = this->WidestAxis(first, last);
    this->Axes[middle] = static_cast<std::uint8_t>(axis);
    const auto begin = this->Ends.begin();
    const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
      [axis](const End& a, const End& b) { return a.point[axis] < b.point[axis]; });
    constexpr std::size_t WorthAThread = 8192;
    ParallelFor(
      0, 2,
      [&](std::uint64_t part, std::uint64_t end)
      {
        for (; part < end; ++part)
        {
          part == 0 ? this->Sort(first, middle) : this->Sort(middle + 1, last);
        }
      },
      last - first < WorthAThread ? 2 : 1);
  }

  template <class Function>
  void Search(std::size_t first, std::size_t last, const glm::dvec3& least, const glm::dvec3& most,
    const Function& f) const
  {
    while (first < last)
    {
      const std::size_t middle = first + (last - first) / 2;
      const glm::dvec3& point = this->Ends[middle].point;
      if (glm::all(glm::lessThanEqual(least, point)) && glm::all(glm::lessThanEqual(point, most)))
      {
        f(this->Ends[middle]);
      }
      const int axis = this->Axes[middle];
      if (least[axis] <= point[axis])
      {
        this->Search(first, middle, least, most, f);
      }
      if (most[axis] < point[axis])
      {
        return;
      }
      first = middle + 1;
    }
  }

  std::vector<End> Ends;
  std::vector<std::uint8_t> Axes; ///< Of each end, along which it divides its range.
};

} // namespace PhotonTransport
