// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Clearance.h"

#include "PhotonTransport/scene/DoubleSheets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// A lamp this close to a facet, relative to the reach of the place, touches it: positions are
/// often written with six or seven digits, as single precision has them.
constexpr double Touching = 0x1p-17;

/// How far in front of a facet that it touches a lamp is put, relative to the reach.
constexpr double Clear = 2.0 * Touching;

/// Below this cosine a lamp shines along a facet, and to neither side of it.
constexpr double Along = 1e-3;

/// Above this cosine two planes face the same way.
constexpr double SamePlane = 0.999;

/// A lamp is not moved further than this, relative to Clear: to the bisector of an edge of half a
/// degree.
constexpr double Farthest = 256.0;

/// The lamp is to stand at `distance` or more above the plane through `point`.
struct HalfSpace
{
  glm::dvec3 point;
  glm::dvec3 normal;
  double distance;
  const Facet* facet; ///< Which it touches.
};

/// The half-space into which a lamp that touches the facet is to be moved.
HalfSpace SideOf(const Scene& scene, const Facet& facet, const glm::dvec3& aim, double distance)
{
  const glm::dvec3 normal(facet.normal);
  const bool back = glm::dot(aim, normal) < -Along;
  // A lamp that aims against the normal shines to the back of the facet, so it is put there.
  return { glm::dvec3(scene.Vertices()[facet.vertices.x].position), back ? -normal : normal,
    distance, &facet };
}

/// Whether a corner of the facet lies clearly in front of the side.
bool ReachesInFront(const Scene& scene, const Facet& facet, const HalfSpace& side)
{
  bool reaches = false;
  for (int c = 0; c < 3; ++c)
  {
    const glm::dvec3 corner(scene.Vertices()[facet.vertices[c]].position);
    reaches = reaches || glm::dot(corner - side.point, side.normal) > 2.0 * side.distance;
  }
  return reaches;
}

/// Whether a lamp that stands clear of one side stands clear of the other: their planes face the
/// same way, or opposite ways as those of double sheets and thin plates do. Between the walls of an
/// acute edge it does not: each of them lies in front of the other.
bool AreOne(const Scene& scene, const HalfSpace& a, const HalfSpace& b)
{
  const double cosine = glm::dot(a.normal, b.normal);
  return std::fabs(cosine) > SamePlane &&
    (cosine > 0.0 || !ReachesInFront(scene, *a.facet, b) || !ReachesInFront(scene, *b.facet, a));
}

void AddTouched(
  const Scene& scene, const glm::dvec3& place, const glm::dvec3& aim, std::vector<HalfSpace>& sides)
{
  const double reach = scene.Reach(place);
  const auto corner = [&](const Facet& facet, int c)
  { return glm::dvec3(scene.Vertices()[facet.vertices[c]].position); };
  std::set<std::uint32_t> candidates; // in the order of the list, whatever the order of the search
  scene.ForEachNear(glm::vec3(place), static_cast<float>(2.0 * Touching * reach),
    [&](std::uint32_t f) { candidates.insert(f); });
  for (const std::uint32_t f : candidates)
  {
    const Facet& facet = scene.Facets()[f];
    const HalfSpace side = SideOf(scene, facet, aim, Clear * reach);
    const bool isNew = std::none_of(sides.begin(), sides.end(),
      [&](const HalfSpace& known) { return AreOne(scene, known, side); });
    if (isNew &&
      Within(place, Touching * reach, corner(facet, 0), corner(facet, 1), corner(facet, 2)))
    {
      sides.push_back(side);
    }
  }
}

/// By how much a lamp is too near to a side; 0 if it stands clear of it, or is so far behind that
/// the side is not its own.
double Missing(const HalfSpace& side, const std::vector<glm::dvec3>& places)
{
  double most = 0.0;
  for (const glm::dvec3& place : places)
  {
    const double missing = side.distance - glm::dot(place - side.point, side.normal);
    most = missing < 4.0 * side.distance ? std::max(most, missing) : most;
  }
  return most;
}

/// A plane that a way from the origin is to reach.
struct Plane
{
  glm::dvec3 normal;
  double distance; ///< From the origin.
};

/// The least vector to the line or point that up to three planes have in common; not finite if
/// there is none.
glm::dvec3 LeastOnPlanes(const std::vector<Plane>& planes)
{
  if (planes.empty())
  {
    return glm::dvec3(0.0);
  }
  // The vector lies in the span of the normals; they are made orthogonal (Gram and Schmidt).
  glm::dvec3 way(0.0);
  std::vector<glm::dvec3> axes;
  for (const Plane& plane : planes)
  {
    glm::dvec3 axis = plane.normal;
    for (const glm::dvec3& other : axes)
    {
      axis -= glm::dot(axis, other) * other;
    }
    axis = glm::normalize(axis);
    way += axis * ((plane.distance - glm::dot(way, plane.normal)) / glm::dot(axis, plane.normal));
    axes.push_back(axis);
  }
  return way;
}

/// The least way that leads to or beyond each of the first `count` planes and onto all of `on`. If
/// the least way for the planes before it misses a plane, the least way lies on that plane (Seidel,
/// "Small-Dimensional Linear Programming and Convex Hulls Made Easy", 1991, for a norm). Not finite
/// if there is none.
glm::dvec3 LeastWay(const std::vector<Plane>& planes, std::size_t count, std::vector<Plane> on)
{
  constexpr double Rounding = 1e-9; // of the distances
  glm::dvec3 way = LeastOnPlanes(on);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (glm::dot(way, planes[i].normal) < planes[i].distance * (1.0 - Rounding))
    {
      if (on.size() == 3)
      {
        return glm::dvec3(std::numeric_limits<double>::infinity());
      }
      std::vector<Plane> withThis = on;
      withThis.push_back(planes[i]);
      way = LeastWay(planes, i, std::move(withThis));
    }
  }
  return way;
}

} // namespace

glm::dvec3 WayClearOfFacets(
  const Scene& scene, const std::vector<glm::dvec3>& places, const glm::dvec3& aim)
{
  std::vector<HalfSpace> sides;
  for (const glm::dvec3& place : places)
  {
    AddTouched(scene, place, aim, sides);
  }
  // In an edge or a corner each step towards one side may leave another; it takes a few rounds.
  glm::dvec3 way(0.0);
  constexpr int MostRounds = 64;
  bool clear = false;
  for (int round = 0; round < MostRounds && !clear; ++round)
  {
    clear = true;
    for (const HalfSpace& side : sides)
    {
      for (const glm::dvec3& place : places)
      {
        const double missing = side.distance - glm::dot(place + way - side.point, side.normal);
        if (missing > 0.01 * side.distance && missing < 4.0 * side.distance)
        {
          way += missing * side.normal;
          clear = false;
        }
      }
    }
  }
  if (clear)
  {
    return way;
  }
  // Between walls at an angle a it would take some 1 / a^2 rounds.
  std::vector<Plane> planes;
  double distance = 0.0;
  for (const HalfSpace& side : sides)
  {
    planes.push_back({ side.normal, Missing(side, places) });
    distance = std::max(distance, side.distance);
  }
  const glm::dvec3 least = LeastWay(planes, planes.size(), {});
  return glm::length(least) <= Farthest * distance ? least : way;
}

} // namespace PhotonTransport
