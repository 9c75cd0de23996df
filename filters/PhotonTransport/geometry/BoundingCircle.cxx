// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/BoundingCircle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace PhotonTransport
{
namespace
{

using Points = std::vector<glm::dvec2>;

/// Points on the rim must not count as outside for their last digit.
bool Holds(const Circle& circle, const glm::dvec2& point)
{
  constexpr double Slack = 1.0 + 1e-12;
  return glm::length(point - circle.centre) <= circle.radius * Slack;
}

Circle Through(const glm::dvec2& a, const glm::dvec2& b)
{
  return { 0.5 * (a + b), 0.5 * glm::length(b - a) };
}

Circle Through(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const glm::dvec2 u = b - a;
  const glm::dvec2 v = c - a;
  const double twiceCross = 2.0 * (u.x * v.y - u.y * v.x);
  const glm::dvec2 fromA((v.y * glm::dot(u, u) - u.y * glm::dot(v, v)) / twiceCross,
    (u.x * glm::dot(v, v) - v.x * glm::dot(u, u)) / twiceCross);
  // Three points on a line (or two alike) have no circle; the last two span them well enough here,
  // and the radius is set to hold all points in the end.
  return std::isfinite(fromA.x + fromA.y) ? Circle{ a + fromA, glm::length(fromA) } : Through(b, c);
}

/// Smallest circle of the first `count` points that passes through two given ones.
Circle Around(const Points& points, std::size_t count, const glm::dvec2& p, const glm::dvec2& q)
{
  Circle circle = Through(p, q);
  for (std::size_t k = 0; k < count; ++k)
  {
    circle = Holds(circle, points[k]) ? circle : Through(p, q, points[k]);
  }
  return circle;
}

/// Smallest circle of the first `count` points that passes through a given one.
Circle Around(const Points& points, std::size_t count, const glm::dvec2& p)
{
  Circle circle{ p, 0.0 };
  for (std::size_t j = 0; j < count; ++j)
  {
    circle = Holds(circle, points[j]) ? circle : Around(points, j, p, points[j]);
  }
  return circle;
}

} // namespace

Circle BoundingCircle(Points points)
{
  std::shuffle(points.begin(), points.end(), std::mt19937(1)); // the linear time needs random order
  Circle circle;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i == 0 || !Holds(circle, points[i]))
    {
      circle = Around(points, i, points[i]);
    }
  }
  for (const glm::dvec2& point : points)
  {
    circle.radius = std::max(circle.radius, glm::length(point - circle.centre));
  }
  return circle;
}

} // namespace PhotonTransport
