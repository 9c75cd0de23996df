// SPDX-License-Identifier: BSD-3-Clause
// Small things on large sites: a ray's rounding is that of the place, not that of the site.
#include "CoreTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

/// A terrain of half-width `half` m at z = -0.5 m; the things on it stand about `place`.
struct Site
{
  double half;
  glm::dvec3 place;
  int cells; ///< Squares of the terrain along each side.
};

std::vector<Site> Sites()
{
  std::vector<Site> sites;
  for (const double half : { 10.0, 2.5e3, 5e3, 5e4 })
  {
    for (const int cells : { 1, 100 })
    {
      sites.push_back({ half, glm::dvec3(0.0), cells });
      sites.push_back({ half, glm::dvec3(1e6 / 3.0, -1e6, 100.0), cells });
      sites.push_back({ half, glm::dvec3(0.6 * half, -0.55 * half, 0.0), cells });
    }
  }
  return sites;
}

std::string NameOf(const Site& site)
{
  return std::to_string(site.half) + " m, " + std::to_string(site.cells) + " cells, at " +
    std::to_string(site.place.x);
}

/// The terrain is centred at the world's origin or, where the place is beyond it, there.
glm::dvec3 CentreOf(const Site& site)
{
  return std::fabs(site.place.x) > site.half ? site.place : glm::dvec3(0.0);
}

Surface Terrain(const Site& site)
{
  const glm::dvec3 corner = CentreOf(site) + glm::dvec3(-site.half, -site.half, -0.5);
  return Shapes::Rectangle(
    corner, { 2.0 * site.half, 0, 0 }, { 0, 2.0 * site.half, 0 }, site.cells);
}

Surface BoxAt(const Site& site, const glm::dvec3& low, const glm::dvec3& high, int cells, Facing f)
{
  return Shapes::Box(site.place + low, site.place + high, cells, f);
}

/// Flux on the fronts of the vertices [first, last), lm.
double FluxOn(const TracedMap& run, std::size_t first, std::size_t last)
{
  double sum = 0.0;
  for (std::size_t v = first; v < last; ++v)
  {
    sum += (run.front.direct[v] + run.front.indirect[v]) * run.scene.VertexAreas()[v];
  }
  return sum;
}

TraceSettings FlatSettings()
{
  TraceSettings settings;
  settings.registration = Registration::Flat;
  return settings;
}

} // namespace

// Starts that are as far from walls as the site's rounding wants keep the light in too; those that
// go by the place are nearer and must not lose it.
TEST(LargeSite, ARoomKeepsItsLight)
{
  std::uint64_t segments = 0;
  for (const Site& site : Sites())
  {
    for (const int cells : { 1, 8 })
    {
      SCOPED_TRACE(NameOf(site) + ", walls of " + std::to_string(cells));
      const Surface room = BoxAt(site, { -2, -2, 0 }, { 2, 2, 3 }, cells, Facing::Inward);
      const Surface all = Shapes::WithReflectance(Shapes::Together(room, Terrain(site)), 0.98f);
      const TracedMap run(
        all, PointLamp{ site.place + glm::dvec3(0.7, 0.4, 2.5), 1000.0 }, FlatSettings(), 4'000);
      EXPECT_EQ(run.balance.escaped, 0u);
      EXPECT_EQ(FluxOn(run, room.points.size(), all.points.size()), 0.0);
      segments += run.balance.segments;
    }
  }
  Report("rooms on large sites that lose their light",
    std::to_string(segments) +
      " segments in rooms of 4 m on sites of 20 m to 100 km: none escaped");
}

// The terrain itself is the floor, on which the walls stand without sharing a point with it.
TEST(LargeSite, ARoomOnBareGroundKeepsItsLight)
{
  std::uint64_t segments = 0;
  for (const Site& site : Sites())
  {
    SCOPED_TRACE(NameOf(site));
    Surface room = BoxAt(site, { -2, -2, -0.5 }, { 2, 2, 2.5 }, 8, Facing::Inward);
    const auto isFloor = [&](const glm::uvec3& facet) { return room.normals[facet.x].z > 0.5; };
    room.facets.erase(
      std::remove_if(room.facets.begin(), room.facets.end(), isFloor), room.facets.end());
    const Surface all = Shapes::WithReflectance(Shapes::Together(room, Terrain(site)), 0.98f);
    const TracedMap run(
      all, PointLamp{ site.place + glm::dvec3(0.7, 0.4, 2.0), 1000.0 }, FlatSettings(), 4'000);
    EXPECT_EQ(run.balance.escaped, 0u);
    segments += run.balance.segments;
  }
  Report("walls on a terrain with which they share no point: light that leaks below them",
    std::to_string(segments) + " segments, sites of 20 m to 100 km: none escaped");
}

TEST(LargeSite, ThinCavitiesKeepTheirLight)
{
  std::uint64_t segments = 0;
  for (const Site& site : Sites())
  {
    SCOPED_TRACE(NameOf(site));
    const Surface cavity = BoxAt(site, { 0, 0, 1 }, { 1, 1, 1.0005 }, 2, Facing::Inward);
    const Surface all = Shapes::WithReflectance(Shapes::Together(cavity, Terrain(site)), 0.5f);
    const TracedMap run(all, PointLamp{ site.place + glm::dvec3(0.52, 0.51, 1.00025), 1000.0 },
      FlatSettings(), 20'000);
    EXPECT_EQ(run.balance.escaped, 0u);
    EXPECT_EQ(FluxOn(run, cavity.points.size(), all.points.size()), 0.0);
    segments += run.balance.segments;
  }
  Report("rays that start beyond the other wall of a thin cavity",
    std::to_string(segments) + " segments in cavities of 0.5 mm, sites of 20 m to 100 km: none " +
      "escaped");
}

// A closed shell of two walls 0.5 mm apart, lit from outside by the sun and by a lamp: dark inside,
// as with starts that go by the site.
TEST(LargeSite, ThinWallsKeepLightOut)
{
  std::uint64_t photons = 0;
  for (const Site& site : Sites())
  {
    SCOPED_TRACE(NameOf(site));
    const Surface inside = BoxAt(site, { 0, 0, 1 }, { 1, 1, 2 }, 2, Facing::Inward);
    Surface all = Shapes::Together(inside,
      BoxAt(
        site, { -5e-4, -5e-4, 1 - 5e-4 }, { 1 + 5e-4, 1 + 5e-4, 2 + 5e-4 }, 3, Facing::Outward));
    const std::size_t shell = all.points.size();
    all = Shapes::WithReflectance(Shapes::Together(all, Terrain(site)), 0.5f);
    const SpotLamp spot{ site.place + glm::dvec3(20, 15, 30), { -19.5, -14.5, -28.5 }, 0.05, 0.0,
      1000.0 };
    const TracedMap near(all, spot, FlatSettings(), 20'000);
    EXPECT_EQ(FluxOn(near, 0, inside.points.size()), 0.0);
    EXPECT_GT(FluxOn(near, inside.points.size(), shell), 0.0);
    const glm::dvec3 far = CentreOf(site) + glm::dvec3(0, 0, site.half);
    const SpotLamp distant{ far, site.place + glm::dvec3(0.5, 0.5, 1.5) - far, 1.0 / site.half, 0.0,
      1000.0 };
    const TracedMap fromFar(all, distant, FlatSettings(), 20'000);
    EXPECT_EQ(FluxOn(fromFar, 0, inside.points.size()), 0.0);
    EXPECT_GT(FluxOn(fromFar, inside.points.size(), shell), 0.0);
    photons += near.balance.emitted + fromFar.balance.emitted;
  }
  Report("light that passes through thin walls",
    std::to_string(photons) +
      " photons at walls 0.5 mm apart, sites of 20 m to 100 km: dark inside");
}

// Two panes of 0.5 mm, kilometres apart: they cannot both lie where coordinates are fine. Their
// faces are closer than a ray's start, or, farther away, too small for any ray: both is told.
TEST(LargeSite, GapsThatAreTooThinAreTold)
{
  for (const double half : { 50.0, 1e3, 5e3, 5e4 })
  {
    const Site site{ half, glm::dvec3(0.0), 4 };
    const auto pane = [&](double x) {
      return Shapes::Box({ x, 0, 1 }, { x + 1, 5e-4, 2 }, 2, Facing::Outward);
    };
    Surface all = Shapes::Together(pane(-half), pane(half - 1.0));
    const std::size_t panes = all.facets.size();
    all = Shapes::Together(all, Terrain(site));
    all.materials.assign(2, {});
    all.materials[0].clearTransmittance = Colour(1.0f);
    all.materials[0].solid = true;
    all.materialOfFacet.assign(all.facets.size(), 1);
    std::fill_n(all.materialOfFacet.begin(), panes, 0u);
    const Scene scene(all);
    const ThinGaps& gaps = scene.Notes().thinGaps;
    SCOPED_TRACE(half);
    EXPECT_EQ(gaps.unresolved, half > 1e4 ? panes : 0u);
    if (half < 1e3 || half > 1e4)
    {
      EXPECT_EQ(gaps.number, 0u);
      continue;
    }
    EXPECT_GT(gaps.number, 0u);
    EXPECT_NEAR(gaps.gap, 5e-4, 0x1p-24 * half); // the rounding of such a coordinate
    EXPECT_GT(gaps.offset, gaps.gap);
    EXPECT_LT(std::max(gaps.facet, gaps.other), panes);
    // Opaque, the same bodies are full of no light.
    all.materials[0] = {};
    EXPECT_EQ(Scene(all).Notes().thinGaps.number, 0u);
  }
  Report("gaps too thin for a ray's rounding", "panes of 0.5 mm 10 and 100 km apart: told");
}
