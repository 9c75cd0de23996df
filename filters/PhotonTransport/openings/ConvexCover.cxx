// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/ConvexCover.h"

#include "PhotonTransport/openings/CoplanarSegments.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

double Turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds one side of the hull, without its last point.
template <typename Iterator>
void AddSide(Iterator first, Iterator last, std::vector<glm::dvec2>& hull)
{
  const std::size_t before = hull.size();
  for (; first != last; ++first)
  {
    while (hull.size() >= before + 2 && Turn(hull[hull.size() - 2], hull.back(), *first) <= 0.0)
    {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();
}

/// Counter-clockwise.
std::vector<glm::dvec2> HullOf(std::vector<glm::dvec2> points)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  AddSide(points.begin(), points.end(), hull);
  AddSide(points.rbegin(), points.rend(), hull);
  return hull;
}

} // namespace

ConvexCover CoverOf(const std::vector<TriangleCorners>& triangles)
{
  ConvexCover cover;
  Plane plane{ glm::dvec3(0.0), glm::dvec3(0.0) };
  for (const TriangleCorners& t : triangles)
  {
    plane.normal += glm::cross(t[1] - t[0], t[2] - t[0]);
    plane.point += (t[0] + t[1] + t[2]) / (3.0 * static_cast<double>(triangles.size()));
  }
  cover.normal = plane.normal = glm::normalize(plane.normal);
  const glm::dvec3 u = plane.AnyDirection(), v = glm::cross(plane.normal, u);
  std::vector<glm::dvec2> projected;
  for (const TriangleCorners& t : triangles)
  {
    for (const glm::dvec3& corner : t)
    {
      const glm::dvec3 from = corner - plane.point;
      projected.emplace_back(glm::dot(from, u), glm::dot(from, v));
      const double height = glm::dot(from, plane.normal);
      cover.above = std::max(cover.above, height);
      cover.below = std::max(cover.below, -height);
    }
  }
  const std::vector<glm::dvec2> hull = HullOf(std::move(projected));
  const auto inSpace = [&](const glm::dvec2& p) { return plane.point + p.x * u + p.y * v; };
  for (std::size_t i = 2; i < hull.size(); ++i)
  {
    cover.triangles.push_back({ inSpace(hull[0]), inSpace(hull[i - 1]), inSpace(hull[i]) });
  }
  return cover;
}

} // namespace PhotonTransport
