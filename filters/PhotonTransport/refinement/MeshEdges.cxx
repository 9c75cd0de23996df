// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/MeshEdges.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace PhotonTransport
{
namespace
{

std::tuple<double, double, double> Coordinates(const glm::dvec3& point)
{
  return { point.x, point.y, point.z };
}

/// [point] The first point of the list that is in the same place.
std::vector<std::uint32_t> FirstInPlace(const TriangleMesh& mesh)
{
  std::vector<std::uint32_t> used;
  used.reserve(3 * mesh.facets.size());
  for (const glm::uvec3& facet : mesh.facets)
  {
    used.insert(used.end(), { facet.x, facet.y, facet.z });
  }
  tbb::parallel_sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  tbb::parallel_sort(used.begin(), used.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      return std::tuple(Coordinates(mesh.points[a]), a) <
        std::tuple(Coordinates(mesh.points[b]), b);
    });
  std::vector<std::uint32_t> first(mesh.points.size());
  std::iota(first.begin(), first.end(), 0u);
  for (std::size_t i = 1; i < used.size(); ++i)
  {
    if (mesh.points[used[i]] == mesh.points[used[i - 1]])
    {
      first[used[i]] = first[used[i - 1]];
    }
  }
  return first;
}

/// A side and what edges are told apart by.
struct Side
{
  std::uint32_t placeFrom, placeTo; ///< The first points there; placeFrom is not the greater.
  std::uint32_t from, to;           ///< The facet's own points there.
  std::uint32_t place;              ///< 3 * facet + side

  auto Edge() const { return std::tuple(this->placeFrom, this->placeTo); }
  auto Pair() const { return std::tuple(this->placeFrom, this->placeTo, this->from, this->to); }
  bool operator<(const Side& other) const
  {
    return std::tuple(this->Pair(), this->place) < std::tuple(other.Pair(), other.place);
  }
};

std::vector<Side> SortedSides(const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> first = FirstInPlace(mesh);
  std::vector<Side> sides;
  sides.reserve(3 * mesh.facets.size());
  for (const glm::uvec3& facet : mesh.facets)
  {
    for (int side = 0; side < 3; ++side)
    {
      std::uint32_t from = facet[(side + 1) % 3], to = facet[(side + 2) % 3];
      if (first[to] < first[from])
      {
        std::swap(from, to);
      }
      sides.push_back(
        { first[from], first[to], from, to, static_cast<std::uint32_t>(sides.size()) });
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  return sides;
}

} // namespace

MeshEdges::MeshEdges(const TriangleMesh& mesh)
{
  const std::vector<Side> sides = SortedSides(mesh);
  this->PairOfSide.resize(sides.size());
  this->Sides.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const bool newEdge = i == 0 || sides[i].Edge() != sides[i - 1].Edge();
    if (newEdge)
    {
      this->FirstSides.push_back(static_cast<std::uint32_t>(i));
    }
    if (newEdge || sides[i].Pair() != sides[i - 1].Pair())
    {
      const auto edge = static_cast<std::uint32_t>(this->FirstSides.size() - 1);
      this->PointPairs.push_back({ sides[i].from, sides[i].to, edge });
    }
    this->PairOfSide[sides[i].place] = static_cast<std::uint32_t>(this->PointPairs.size() - 1);
    this->Sides.push_back(sides[i].place);
  }
  this->FirstSides.push_back(static_cast<std::uint32_t>(sides.size()));
}

} // namespace PhotonTransport
