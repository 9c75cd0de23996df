// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/MeshEdges.h"

#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
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

bool IsNear(const glm::dvec3& a, const glm::dvec3& b, double gap)
{
  return glm::distance(a, b) <= gap;
}

std::uint32_t RootOf(const std::vector<std::uint32_t>& places, std::uint32_t place)
{
  while (places[place] != place)
  {
    place = places[place];
  }
  return place;
}

void Join(std::vector<std::uint32_t>& places, std::uint32_t one, std::uint32_t other)
{
  const std::uint32_t a = RootOf(places, one), b = RootOf(places, other);
  places[std::max(a, b)] = std::min(a, b);
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

/// @param first [point] The first point in its place.
std::vector<Side> SortedSides(const TriangleMesh& mesh, const std::vector<std::uint32_t>& first)
{
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
  std::vector<std::uint32_t> places = FirstInPlace(mesh);
  this->Build(mesh, places);
  if (this->JoinBorders(mesh, places))
  {
    this->Build(mesh, places);
  }
}

void MeshEdges::Build(const TriangleMesh& mesh, const std::vector<std::uint32_t>& places)
{
  const std::vector<Side> sides = SortedSides(mesh, places);
  this->PointPairs.clear();
  this->Sides.clear();
  this->FirstSides.clear();
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

std::vector<End> MeshEdges::OpenEnds(const TriangleMesh& mesh) const
{
  std::vector<End> ends;
  for (std::uint32_t edge = 0; edge < this->Number(); ++edge)
  {
    if (this->NumberOfFacets(edge) == 1)
    {
      ends.push_back({ mesh.points[this->FirstPair(edge).from], edge });
      ends.push_back({ mesh.points[this->FirstPair(edge).to], edge });
    }
  }
  return ends;
}

/// Makes one place of the ends of two open edges that differ by rounding, and tells whether there
/// were any.
bool MeshEdges::JoinBorders(const TriangleMesh& mesh, std::vector<std::uint32_t>& places) const
{
  const std::vector<End> ends = this->OpenEnds(mesh);
  const SortedEnds sorted(ends);
  PerThread<std::vector<std::array<std::uint32_t, 2>>> onePlace(MostThreadIndices());
  ForEach(ends.size() / 2,
    [&](std::size_t i)
    {
      const End &first = ends[2 * i], &last = ends[2 * i + 1];
      const double gap = GapBetween(first.point, last.point, mesh.rounding);
      if (!(glm::distance(first.point, last.point) > 2.0 * gap))
      {
        return;
      }
      const PointPair& own = this->FirstPair(first.edge);
      const auto join = [&](const End& near)
      {
        const PointPair& other = this->FirstPair(near.edge);
        const bool along = IsNear(mesh.points[other.from], first.point, gap);
        const std::uint32_t otherFrom = along ? other.from : other.to;
        const std::uint32_t otherTo = along ? other.to : other.from;
        if (near.edge > first.edge && IsNear(mesh.points[otherFrom], first.point, gap) &&
          IsNear(mesh.points[otherTo], last.point, gap))
        {
          onePlace.Own().push_back({ own.from, otherFrom });
          onePlace.Own().push_back({ own.to, otherTo });
        }
      };
      sorted.ForEachWithin(first.point - gap, first.point + gap, join);
    });
  // A place is the least of those that it is joined of, in whichever order.
  bool joined = false;
  for (const auto& pairs : onePlace)
  {
    for (const auto& [one, other] : pairs)
    {
      Join(places, one, other);
      joined = true;
    }
  }
  for (std::uint32_t& place : places)
  {
    place = RootOf(places, place);
  }
  return joined;
}

} // namespace PhotonTransport
