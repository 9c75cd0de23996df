// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/OpenEdges.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// How near a point must be to lie on an edge, relative to the coordinates: their rounding to
/// single precision and that of the edge's ends.
constexpr double OnEdge = 0x1p-21;

double LargestCoordinate(const glm::dvec3& p)
{
  return std::max({ std::fabs(p.x), std::fabs(p.y), std::fabs(p.z) });
}

/// An end of an open edge.
struct End
{
  glm::dvec3 point;
  std::uint32_t edge;
};

/// The ends of all open edges, sorted along each axis, so that a search can take the one along
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

/// Adds the edge and those along it, if it has a point between its ends.
void AddIfDivided(std::uint32_t edge, const glm::dvec3& from, const glm::dvec3& to,
  const SortedEnds& ends, std::vector<std::uint32_t>& found)
{
  const double gap = OnEdge * std::max(LargestCoordinate(from), LargestCoordinate(to));
  const glm::dvec3 along = to - from;
  const double length = glm::length(along);
  if (!(length > 2.0 * gap))
  {
    return;
  }
  const auto [first, last] = ends.Near(glm::min(from, to) - gap, glm::max(from, to) + gap);
  std::vector<std::uint32_t> onEdge; // an edge with both ends here is here twice
  bool divided = false;
  for (const End* end = first; end != last; ++end)
  {
    const glm::dvec3 beside = end->point - from;
    const double place = std::clamp(glm::dot(beside, along) / length, 0.0, length);
    if (end->edge != edge && glm::length(beside - (place / length) * along) <= gap)
    {
      divided = divided || (place > gap && place < length - gap);
      onEdge.push_back(end->edge);
    }
  }
  if (divided)
  {
    found.push_back(edge);
    std::sort(onEdge.begin(), onEdge.end());
    for (auto twice = std::adjacent_find(onEdge.begin(), onEdge.end()); twice != onEdge.end();
         twice = std::adjacent_find(twice + 2, onEdge.end()))
    {
      found.push_back(*twice);
    }
  }
}

} // namespace

std::vector<std::uint32_t> EdgesWithPointsOnThem(const TriangleMesh& mesh, const MeshEdges& edges)
{
  std::vector<End> ends;
  for (std::uint32_t edge = 0; edge < edges.Number(); ++edge)
  {
    if (edges.NumberOfFacets(edge) == 1)
    {
      ends.push_back({ mesh.points[edges.FirstPair(edge).from], edge });
      ends.push_back({ mesh.points[edges.FirstPair(edge).to], edge });
    }
  }
  const SortedEnds sorted(ends);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    AddIfDivided(ends[i].edge, ends[i].point, ends[i + 1].point, sorted, found);
  }
  return found;
}

} // namespace PhotonTransport
