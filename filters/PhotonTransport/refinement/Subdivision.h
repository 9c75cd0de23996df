// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// A triangle within a facet: the facet's barycentric coordinates of its corners. They are
/// multiples of a power of two, so halving is exact.
using FacetTriangle = std::array<glm::vec3, 3>;

constexpr FacetTriangle WholeFacet{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };

/// The triangles, two to four, that a triangle falls into when its marked edges are halved.
struct Children
{
  std::array<FacetTriangle, 4> triangles;
  int number = 0;

  void Add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
  {
    this->triangles[static_cast<std::size_t>(this->number++)] = { a, b, c };
  }
};

/// @param halved Edge i is opposite to corner i. At least one is.
inline Children Halve(const FacetTriangle& triangle, const std::array<bool, 3>& halved)
{
  const int number = halved[0] + halved[1] + halved[2];
  // Turned so that edge 0 is halved where one is, and is the one that is not where two are.
  std::size_t first = 0;
  while (halved[first] != (number != 2))
  {
    ++first;
  }
  const glm::vec3 &a = triangle[first], &b = triangle[(first + 1) % 3],
                  &c = triangle[(first + 2) % 3];
  const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
  Children children;
  if (number == 1)
  {
    children.Add(a, b, bc);
    children.Add(a, bc, c);
    return children;
  }
  children.Add(a, ab, ca);
  if (number == 2)
  {
    children.Add(ab, b, c);
    children.Add(ab, c, ca);
    return children;
  }
  children.Add(ab, b, bc);
  children.Add(ca, bc, c);
  children.Add(ab, bc, ca);
  return children;
}

/// Divides a triangle by halving its edges, then the edges of its parts, and so on (red-green
/// refinement). Whether an edge is halved depends on the edge alone, so parts that share an edge
/// meet without a gap, and no part has a vertex inside an edge of another.
/// @param halves Called as halves(p, q) with the ends of an edge; halves(q, p) must be the same.
/// @param keep Called with each FacetTriangle that is not divided.
template <class HalvesEdge, class Keep>
void Subdivide(const FacetTriangle& triangle, const HalvesEdge& halves, const Keep& keep)
{
  std::array<bool, 3> halved{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    halved[i] = halves(triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
  }
  if (!halved[0] && !halved[1] && !halved[2])
  {
    keep(triangle);
    return;
  }
  const Children children = Halve(triangle, halved);
  for (int i = 0; i < children.number; ++i)
  {
    Subdivide(children.triangles[static_cast<std::size_t>(i)], halves, keep);
  }
}

} // namespace PhotonTransport
