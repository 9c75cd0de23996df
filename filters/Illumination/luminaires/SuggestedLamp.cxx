// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/SuggestedLamp.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace Illumination
{
namespace
{

constexpr double Down = -0.5; ///< A ceiling's normals have a z below it, a floor's one above 0.5.
constexpr double BelowCeiling = 0.15; ///< Share of the height of a room.
constexpr std::size_t Ceilings = 16;  ///< The largest facets of ceilings to look below.

struct Facet
{
  glm::dvec3 corners[3];
  glm::dvec3 area; ///< Along the normal of the lit side, as long as the area.

  glm::dvec3 Centre() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
};

std::vector<Facet> FacetsOf(const LitTriangles& surface)
{
  std::vector<Facet> facets;
  facets.reserve(surface.facets.size());
  for (const glm::uvec3& ids : surface.facets)
  {
    Facet facet{ { surface.points[ids.x], surface.points[ids.y], surface.points[ids.z] }, {} };
    facet.area =
      0.5 * glm::cross(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]);
    const glm::dvec3 normal =
      surface.normals[ids.x] + surface.normals[ids.y] + surface.normals[ids.z];
    if (glm::dot(facet.area, normal) < 0.0)
    {
      facet.area = -facet.area;
    }
    facets.push_back(facet);
  }
  return facets;
}

struct Overview
{
  glm::dvec3 least{ std::numeric_limits<double>::max() };
  glm::dvec3 greatest{ std::numeric_limits<double>::lowest() };
  glm::dvec3 area{ 0.0 }; ///< Sum of the facets' areas along their normals.
  double wholeArea = 0.0; ///< Sum of the facets' areas.
  double ceiling = 0.0;   ///< Area in plan of the facets that look down.
  double outward = 0.0;   ///< Sum of areas times distance, below 0 if normals point inward.
  double distances = 0.0; ///< The same without signs.

  glm::dvec3 Centre() const { return 0.5 * (least + greatest); }
  double Diagonal() const { return glm::length(greatest - least); }
};

Overview OverviewOf(const std::vector<Facet>& facets)
{
  Overview seen;
  for (const Facet& facet : facets)
  {
    for (const glm::dvec3& corner : facet.corners)
    {
      seen.least = glm::min(seen.least, corner);
      seen.greatest = glm::max(seen.greatest, corner);
    }
  }
  for (const Facet& facet : facets)
  {
    const double outward = glm::dot(facet.area, facet.Centre() - seen.Centre());
    seen.area += facet.area;
    seen.wholeArea += glm::length(facet.area);
    seen.ceiling += std::max(-facet.area.z, 0.0);
    seen.outward += outward;
    seen.distances += std::abs(outward);
  }
  return seen;
}

/// Height at which the vertical line through (x, y) meets a facet, or nothing.
std::optional<double> HeightAt(const Facet& facet, const glm::dvec2& place)
{
  const auto twice = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  double shares[3];
  for (int i = 0; i < 3; ++i)
  {
    shares[i] = twice(glm::dvec2(facet.corners[(i + 1) % 3]) - place,
      glm::dvec2(facet.corners[(i + 2) % 3]) - place);
  }
  const double sum = shares[0] + shares[1] + shares[2];
  if (sum == 0.0 || shares[0] * sum < 0.0 || shares[1] * sum < 0.0 || shares[2] * sum < 0.0)
  {
    return std::nullopt;
  }
  return (shares[0] * facet.corners[0].z + shares[1] * facet.corners[1].z +
           shares[2] * facet.corners[2].z) /
    sum;
}

/// A place below the highest ceiling above (x, y), if what is met below it is lit from above.
std::optional<glm::dvec3> PlaceInRoom(const std::vector<Facet>& facets, const glm::dvec2& place)
{
  struct Crossing
  {
    double height;
    bool looksDown;
  };
  std::vector<Crossing> crossings;
  for (const Facet& facet : facets)
  {
    const auto height = HeightAt(facet, place);
    if (height && facet.area.z != 0.0)
    {
      crossings.push_back({ *height, facet.area.z < 0.0 });
    }
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const Crossing& a, const Crossing& b) { return a.height > b.height; });
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    const double room = crossings[i].height - crossings[i + 1].height;
    if (crossings[i].looksDown && !crossings[i + 1].looksDown && room > 0.0)
    {
      return glm::dvec3(place, crossings[i].height - BelowCeiling * room);
    }
  }
  return std::nullopt;
}

/// The centres of the largest facets of ceilings.
std::vector<glm::dvec2> PlacesBelowCeilings(const std::vector<Facet>& facets)
{
  std::vector<const Facet*> ceilings;
  for (const Facet& facet : facets)
  {
    if (facet.area.z < Down * glm::length(facet.area))
    {
      ceilings.push_back(&facet);
    }
  }
  const auto end = ceilings.begin() + static_cast<long>(std::min(Ceilings, ceilings.size()));
  std::partial_sort(ceilings.begin(), end, ceilings.end(),
    [](const Facet* a, const Facet* b) { return a->area.z < b->area.z; });
  std::vector<glm::dvec2> places;
  std::transform(ceilings.begin(), end, std::back_inserter(places),
    [](const Facet* facet) { return glm::dvec2(facet->Centre()); });
  return places;
}

/// Most normals point inward, and there is a ceiling over a good part of the plan.
bool IsRoom(const Overview& seen)
{
  const glm::dvec3 lengths = seen.greatest - seen.least;
  return seen.outward < -0.1 * seen.distances && seen.ceiling > 0.3 * lengths.x * lengths.y &&
    seen.distances > 0.01 * seen.wholeArea * seen.Diagonal(); // not flat
}

std::optional<glm::dvec3> PlaceInRoom(const std::vector<Facet>& facets, const Overview& seen)
{
  if (!IsRoom(seen))
  {
    return std::nullopt;
  }
  // A little off the middle, where edges between facets often are.
  const glm::dvec3 middle = seen.Centre() + 1e-3 * glm::dvec3(0.71, 0.53, 0.0) * seen.Diagonal();
  if (const auto place = PlaceInRoom(facets, glm::dvec2(middle)))
  {
    return place;
  }
  for (const glm::dvec2& place : PlacesBelowCeilings(facets))
  {
    if (const auto found = PlaceInRoom(facets, place))
    {
      return found;
    }
  }
  return std::nullopt;
}

/// Straight down, unless less than a fifth of the surface would be lit more than away from it.
glm::dvec3 DirectionOnto(const Overview& seen)
{
  const glm::dvec3 mean = seen.area / seen.wholeArea;
  return glm::length(mean) < 0.2 || mean.z > 0.2 ? glm::dvec3(0.0, 0.0, -1.0)
                                                 : -glm::normalize(mean);
}

} // namespace

SuggestedLamp SuggestLamp(const LitTriangles& surface)
{
  SuggestedLamp lamp;
  const std::vector<Facet> facets = FacetsOf(surface);
  const Overview seen = OverviewOf(facets);
  if (facets.empty() || !(seen.wholeArea > 0.0))
  {
    return lamp;
  }
  lamp.size = 0.05 * seen.Diagonal();
  if (const auto place = PlaceInRoom(facets, seen))
  {
    lamp.isParallel = false;
    lamp.position = *place;
    return lamp;
  }
  lamp.direction = DirectionOnto(seen);
  lamp.position = seen.Centre() - 0.6 * seen.Diagonal() * lamp.direction;
  return lamp;
}

} // namespace Illumination
