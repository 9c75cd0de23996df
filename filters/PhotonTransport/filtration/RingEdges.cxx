// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/RingEdges.h"

#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Twice the area vector.
glm::dvec3 DoubleArea(const std::vector<glm::dvec3>& points, const glm::uvec3& facet)
{
  const glm::dvec3& a = points[facet.x];
  return glm::cross(points[facet.y] - a, points[facet.z] - a);
}

/// Cotangent of the angle at `a` of a triangle; 0 where it has no area.
float Cotangent(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const double area = glm::length(glm::cross(u, v));
  return area > 0.0 ? static_cast<float>(glm::dot(u, v) / area) : 0.0f;
}

} // namespace

/// One facet as seen from one of its edges at a vertex.
struct RingEdges::Side
{
  std::uint32_t neighbour; ///< The edge's other end.
  std::uint32_t facet;
  std::uint32_t place; ///< Of the facet in the ring.
  float cotangent;     ///< Of the angle opposite the edge.
  bool outgoing;       ///< The facet winds from the vertex to the neighbour.
};

RingEdges::RingEdges(
  const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets, double creaseAngle)
  : Points(points)
  , Facets(facets)
  , Rings(points.size(), facets)
  , Normals(facets.size())
  , CosCrease(static_cast<float>(std::cos(creaseAngle)))
{
  ForEach(facets.size(),
    [&](std::size_t f)
    {
      const glm::dvec3 area = DoubleArea(points, facets[f]);
      const double length = glm::length(area);
      this->Normals[f] = length > 0.0 ? glm::vec3(area / length) : glm::vec3(0.0f);
    });
}

double RingEdges::AreaOf(std::uint32_t vertex) const
{
  double sum = 0.0;
  for (const std::uint32_t f : this->Rings.Of(vertex))
  {
    sum += glm::length(DoubleArea(this->Points, this->Facets[f]));
  }
  return sum / 6.0;
}

std::size_t RingEdges::FirstPlace(std::uint32_t vertex) const
{
  return 2 * static_cast<std::size_t>(this->Rings.Of(vertex).begin() - this->Rings.Of(0).begin());
}

/// Sides of an edge come together, in the order of the facets: sums are the same from both ends.
void RingEdges::CollectSides(std::uint32_t vertex, std::vector<Side>& sides) const
{
  sides.clear();
  std::uint32_t place = 0;
  for (const std::uint32_t f : this->Rings.Of(vertex))
  {
    const glm::uvec3& facet = this->Facets[f];
    const int corner = facet.x == vertex ? 0 : facet.y == vertex ? 1 : 2;
    const std::uint32_t next = facet[(corner + 1) % 3];
    const std::uint32_t last = facet[(corner + 2) % 3];
    if (next == last || next == vertex || last == vertex)
    {
      continue;
    }
    const glm::dvec3& a = this->Points[vertex];
    const glm::dvec3& b = this->Points[next];
    const glm::dvec3& c = this->Points[last];
    sides.push_back({ next, f, place, Cotangent(c, a, b), true });
    sides.push_back({ last, f, place, Cotangent(b, a, c), false });
    ++place;
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::pair(a.neighbour, a.facet) < std::pair(b.neighbour, b.facet); });
}

/// The fold is that of the facets, whichever way they wind.
bool RingEdges::IsCrease(const Side* first, const Side* last) const
{
  if (last - first != 2)
  {
    return last - first > 2;
  }
  const float cosine = glm::dot(this->Normals[first[0].facet], this->Normals[first[1].facet]);
  const bool sameWay = first[0].outgoing != first[1].outgoing;
  return (sameWay ? cosine : -cosine) < this->CosCrease;
}

RingEdge RingEdges::MakeEdge(const Side* first, const Side* last) const
{
  // Obtuse triangles have small and negative weights, which would let noise stand or make it grow;
  // the large ones of needles would let light spread along the needles' short sides alone.
  constexpr float LeastWeight = 0.2f;
  constexpr float MostWeight = 1.0f;
  float weight = 0.0f;
  for (const Side* side = first; side != last; ++side)
  {
    weight += 0.5f * side->cotangent;
  }
  return { first->neighbour, std::clamp(weight, LeastWeight, MostWeight),
    this->IsCrease(first, last), last - first == 1 };
}

void RingEdges::At(std::uint32_t vertex, std::vector<RingEdge>& edges) const
{
  thread_local std::vector<Side> sides;
  this->CollectSides(vertex, sides);
  edges.clear();
  const Side* end = sides.data() + sides.size();
  for (const Side* first = sides.data(); first != end;)
  {
    const Side* last = std::find_if(
      first, end, [&](const Side& side) { return side.neighbour != first->neighbour; });
    edges.push_back(this->MakeEdge(first, last));
    first = last;
  }
}

/// How many fans of facets, each connected by edges, meet at a vertex.
std::size_t RingEdges::Fans(std::uint32_t vertex) const
{
  thread_local std::vector<Side> sides;
  thread_local std::vector<std::uint32_t> parent; // union-find over the ring
  this->CollectSides(vertex, sides);
  parent.resize(sides.size() / 2);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [](std::uint32_t facet)
  {
    while (parent[facet] != facet)
    {
      facet = parent[facet] = parent[parent[facet]];
    }
    return facet;
  };
  std::size_t fans = parent.size();
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const std::uint32_t a = root(sides[i - 1].place);
    const std::uint32_t b = root(sides[i].place);
    if (sides[i - 1].neighbour == sides[i].neighbour && a != b)
    {
      parent[a] = b;
      --fans;
    }
  }
  return fans;
}

Crossing RingEdges::CrossingAt(std::uint32_t vertex, const std::vector<RingEdge>& edges) const
{
  const auto creases =
    std::count_if(edges.begin(), edges.end(), [](const RingEdge& edge) { return edge.crease; });
  if (creases > 0)
  {
    return creases == 2 ? Crossing::AlongCrease : Crossing::None;
  }
  return this->Fans(vertex) > 1 ? Crossing::None : Crossing::Free;
}

} // namespace PhotonTransport
