// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/Opening.h"

#include "PhotonTransport/sampling/Warps.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// By how much a triangle is widened, relative to the opening, lest a ray passes between two of
/// them: their common edge is rounded differently in each.
constexpr double Widening = 1e-7;

glm::vec3 CentreOf(const std::vector<Opening::Triangle>& triangles)
{
  glm::vec3 low = triangles.front()[0], high = low;
  for (const Opening::Triangle& triangle : triangles)
  {
    for (const glm::vec3& corner : triangle)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  return 0.5f * (low + high);
}

bool IsIn(const Opening::Triangle& triangle, const glm::dvec3& normal, const glm::dvec3& point,
  double widening)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec3 a(triangle[i]);
    const glm::dvec3 side = glm::dvec3(triangle[(i + 1) % 3]) - a;
    if (glm::dot(normal, glm::cross(side, point - a)) < -widening * glm::length(side))
    {
      return false;
    }
  }
  return true;
}

/// Whether a ray's line may pass through the ball around an opening: a quick answer in single
/// precision, which leaves room for its rounding and for that of the direction's length.
bool MayMeet(const Opening& opening, const Ray& ray)
{
  const glm::vec3 towards = opening.centre - ray.origin;
  const float along = glm::dot(towards, ray.direction), squared = glm::dot(towards, towards);
  return squared - along * along <= 1.01f * opening.radius * opening.radius + 1e-6f * squared;
}

/// The distance at which a ray that crosses the opening's plane does so within the opening.
std::optional<double> DistanceTo(const Opening& opening, const Ray& ray)
{
  const glm::dvec3 origin(ray.origin), direction(ray.direction), normal(opening.normal);
  const glm::dvec3 centre(opening.centre);
  const double distance = glm::dot(normal, glm::dvec3(opening.triangles.front()[0]) - origin) /
    glm::dot(normal, direction);
  const glm::dvec3 point = origin + distance * direction;
  const double radius = opening.radius;
  const bool within = distance > 0.0 && glm::distance(point, centre) <= (1.0 + Widening) * radius &&
    std::any_of(opening.triangles.begin(), opening.triangles.end(),
      [&](const Opening::Triangle& t) { return IsIn(t, normal, point, Widening * radius); });
  return within ? std::optional(distance) : std::nullopt;
}

} // namespace

Opening MakeOpening(
  std::vector<Opening::Triangle> triangles, const glm::vec3& normal, OpeningKind kind)
{
  Opening opening;
  opening.normal = normal;
  opening.kind = kind;
  opening.centre = CentreOf(triangles);
  double area = 0.0;
  for (const Opening::Triangle& t : triangles)
  {
    const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    opening.areas.push_back(static_cast<float>(area));
    for (const glm::vec3& corner : t)
    {
      opening.radius = std::max(opening.radius, glm::distance(corner, opening.centre));
    }
  }
  opening.triangles = std::move(triangles);
  return opening;
}

glm::vec3 Opening::PointAt(float u, float v) const
{
  const float wanted = u * this->Area();
  const auto found = std::upper_bound(this->areas.begin(), this->areas.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(found - this->areas.begin());
  const float before = i == 0 ? 0.0f : this->areas[i - 1];
  const float within = (wanted - before) / (this->areas[i] - before);
  const glm::vec2 place = UniformTriangle(glm::clamp(within, 0.0f, 1.0f), v);
  const Triangle& t = this->triangles[i];
  return t[0] + place.x * (t[1] - t[0]) + place.y * (t[2] - t[0]);
}

std::optional<OpeningCrossing> Openings::FirstCrossing(
  const Ray& ray, bool inwards, float end) const
{
  std::optional<OpeningCrossing> first;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const Opening& opening = this->All[i];
    const float along = glm::dot(opening.normal, ray.direction);
    if ((inwards ? along > 0.0f : along < 0.0f) && MayMeet(opening, ray))
    {
      const std::optional<double> distance = DistanceTo(opening, ray);
      if (distance && *distance < double{ first ? first->distance : end })
      {
        first = OpeningCrossing{ i, static_cast<float>(*distance) };
      }
    }
  }
  return first;
}

} // namespace PhotonTransport
