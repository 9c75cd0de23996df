// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Clearance.h"

#include "PhotonTransport/scene/DoubleSheets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace PhotonTransport
{
namespace
{

/// A lamp this close to a facet, relative to the reach of the place, touches it: positions are
/// often written with six or seven digits, as single precision has them.
constexpr double Touching = 0x1p-17;

/// Where a lamp comes to stand in front of a facet, relative to the reach.
constexpr double Clear = 2.0 * Touching;

/// Below this cosine a lamp shines along a facet, and to neither side of it.
constexpr double Along = 1e-3;

/// Above this cosine two planes face the same way.
constexpr double SamePlane = 0.999;

/// The lamp is to stand at `distance` or more above the plane through `point`.
struct HalfSpace
{
  glm::dvec3 point;
  glm::dvec3 normal;
  double distance;
};

/// The half-space that a lamp is to be in which touches the facet.
HalfSpace SideOf(const Scene& scene, const Facet& facet, const glm::dvec3& aim, double distance)
{
  const glm::dvec3 normal(facet.normal);
  const bool back = glm::dot(aim, normal) < -Along;
  // An aim against the normal is that of a lamp which shines through the facet to its back.
  return { glm::dvec3(scene.Vertices()[facet.vertices.x].position), back ? -normal : normal,
    distance };
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
      [&](const HalfSpace& known)
      { return std::fabs(glm::dot(known.normal, side.normal)) > SamePlane; });
    if (isNew &&
      Within(place, Touching * reach, corner(facet, 0), corner(facet, 1), corner(facet, 2)))
    {
      sides.push_back(side);
    }
  }
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
  return way;
}

} // namespace PhotonTransport
