// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/BorderFacets.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <unordered_set>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// An edge at its point of the lower number.
struct HalfKnownEdge
{
  std::uint32_t other;    ///< Its other point.
  std::uint32_t opposite; ///< The third corner of the facet.
};

/// The edges by their lower points.
struct EdgesByPoint
{
  std::vector<std::size_t> first; ///< Of each point, and their number.
  std::vector<HalfKnownEdge> edges;
};

EdgesByPoint SortedByPoint(const TriangleMesh& mesh)
{
  EdgesByPoint sorted;
  sorted.first.assign(mesh.points.size() + 2, 0);
  const auto forEach = [&](const auto& f)
  {
    for (const glm::uvec3& facet : mesh.facets)
    {
      for (int side = 0; side < 3; ++side)
      {
        const std::uint32_t a = facet[(side + 1) % 3], b = facet[(side + 2) % 3];
        f(std::min(a, b), std::max(a, b), facet[side]);
      }
    }
  };
  forEach([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++sorted.first[low + 2]; });
  for (std::size_t p = 2; p < sorted.first.size(); ++p)
  {
    sorted.first[p] += sorted.first[p - 1];
  }
  sorted.edges.resize(3 * mesh.facets.size());
  forEach(
    [&](std::uint32_t low, std::uint32_t high, std::uint32_t opposite) {
      sorted.edges[sorted.first[low + 1]++] = { high, opposite };
    });
  return sorted;
}

/// Marks the ends of edges that have one facet by their points, or several with the same corners.
std::vector<std::uint8_t> EndsOfSingleEdges(const TriangleMesh& mesh)
{
  EdgesByPoint sorted = SortedByPoint(mesh);
  std::vector<std::uint8_t> isEnd(mesh.points.size(), 0);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const auto begin = sorted.edges.begin() + static_cast<std::ptrdiff_t>(sorted.first[p]);
    const auto end = sorted.edges.begin() + static_cast<std::ptrdiff_t>(sorted.first[p + 1]);
    std::sort(begin, end,
      [](const HalfKnownEdge& a, const HalfKnownEdge& b)
      { return std::pair(a.other, a.opposite) < std::pair(b.other, b.opposite); });
    for (auto edge = begin; edge != end;)
    {
      const auto next =
        std::find_if(edge, end, [&](const HalfKnownEdge& e) { return e.other != edge->other; });
      if (edge->opposite == (next - 1)->opposite)
      {
        isEnd[p] = isEnd[edge->other] = 1;
      }
      edge = next;
    }
  }
  return isEnd;
}

struct PlaceHash
{
  std::size_t operator()(const glm::dvec3& place) const
  {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double coordinate = place[i] + 0.0; // -0 is 0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u; // golden ratio
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Marks the points in the places of marked ones.
void SpreadInPlace(const TriangleMesh& mesh, std::vector<std::uint8_t>& marks)
{
  std::unordered_set<glm::dvec3, PlaceHash> places;
  for (std::size_t p = 0; p < marks.size(); ++p)
  {
    if (marks[p] != 0)
    {
      places.insert(mesh.points[p]);
    }
  }
  for (std::size_t p = 0; p < marks.size() && !places.empty(); ++p)
  {
    marks[p] = marks[p] != 0 || places.count(mesh.points[p]) != 0 ? 1 : 0;
  }
}

} // namespace

BorderFacets FacetsNearBorder(const TriangleMesh& mesh)
{
  BorderFacets border;
  border.isNear = EndsOfSingleEdges(mesh);
  const auto marked = std::count(border.isNear.begin(), border.isNear.end(), std::uint8_t{ 1 });
  if (4 * static_cast<std::size_t>(marked) < mesh.points.size())
  {
    SpreadInPlace(mesh, border.isNear);
  }
  else
  {
    border.isNear.assign(mesh.points.size(), 1); // hardly any facets share points
  }
  for (std::uint32_t f = 0; f < mesh.facets.size(); ++f)
  {
    const glm::uvec3& facet = mesh.facets[f];
    if (border.isNear[facet.x] + border.isNear[facet.y] + border.isNear[facet.z] >= 2)
    {
      border.facets.push_back(f);
    }
  }
  return border;
}

} // namespace PhotonTransport
