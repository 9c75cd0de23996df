// SPDX-License-Identifier: BSD-3-Clause
// Maps that are refined where their light varies.
#include "RefinedMeshes.h"

#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/scene/CurvedSurface.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/RefinedMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace PhotonTransport;
using RefinedMeshes::Gaps;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;

TraceSettings Gathering(int threads = 0)
{
  TraceSettings settings;
  settings.method = Method::FinalGathering;
  settings.gatherRays = 32;
  settings.threads = threads;
  return settings;
}

RefinedMap Refined(const Surface& surface, const Lighting& lighting, const AdaptiveLimits& limits,
  const TraceSettings& settings = Gathering(), std::uint64_t photons = 20'000)
{
  const Scene scene(surface);
  IlluminationRun run(scene, lighting, settings);
  run.Advance({ photons });
  return *run.Refine(surface, limits);
}

double Light(const IlluminationMap& map, std::size_t p)
{
  return map.direct[p] + map.indirect[p];
}

/// A floor of two triangles below a lamp, with a square in between.
struct ShadowedFloor
{
  const PointLamp lamp{ glm::dvec3(0.0, 0.0, 2.0), 1000.0 };
  const Surface floor = Shapes::Rectangle({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 1);
  const Surface blocker = Shapes::Rectangle({ -0.3, -0.55, 1 }, { 0.9, 0, 0 }, { 0, 0.8, 0 }, 1);
  const Surface both = Shapes::Together(floor, blocker);

  /// lx on the floor: I cos / d^2 but for the shadow, which is twice as large as the square.
  double Exact(double x, double y) const
  {
    const bool shadow = x > -0.6 && x < 1.2 && y > -1.1 && y < 0.5;
    const double square = x * x + y * y + 4.0;
    return shadow ? 0.0 : 1000.0 / (4.0 * Pi) * 2.0 / (square * std::sqrt(square));
  }
};

/// RMS error of linear interpolation over the floor, relative to the mean light there: at random
/// points of each facet, weighted by its area.
double ErrorOn(const ShadowedFloor& scene, const RefinedMap& map)
{
  std::mt19937 numbers(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double squares = 0.0, mean = 0.0, area = 0.0;
  for (std::size_t f = 0; f < map.mesh.facets.size(); ++f)
  {
    const glm::uvec3& ids = map.mesh.facets[f];
    const auto point = [&](int c) { return map.mesh.points[ids[c]]; };
    if (map.mesh.origins[f].facet >= scene.floor.facets.size())
    {
      continue;
    }
    const double ofFacet = 0.5 * glm::length(glm::cross(point(1) - point(0), point(2) - point(0)));
    constexpr int Points = 8;
    for (int i = 0; i < Points; ++i)
    {
      const double u = std::sqrt(share(numbers)), v = share(numbers);
      const glm::dvec3 shares(1.0 - u, u * v, u * (1.0 - v));
      const glm::dvec3 at = shares.x * point(0) + shares.y * point(1) + shares.z * point(2);
      const double exact = scene.Exact(at.x, at.y);
      const double light = shares.x * Light(map.front, ids.x) + shares.y * Light(map.front, ids.y) +
        shares.z * Light(map.front, ids.z);
      squares += std::pow(light - exact, 2.0) * ofFacet / Points;
      mean += exact * ofFacet / Points;
    }
    area += ofFacet;
  }
  EXPECT_NEAR(area, 16.0, 1e-9);
  return std::sqrt(squares / area) / (mean / area);
}

} // namespace

TEST(Adaptive, ShadowAppearsOnAFloorOfTwoTriangles)
{
  const ShadowedFloor scene;
  const AdaptiveLimits limits;
  const RefinedMap map = Refined(Shapes::WithReflectance(scene.both, 0.0f), scene.lamp, limits);
  EXPECT_EQ(Gaps(scene.both, map.mesh), 0u);
  EXPECT_FALSE(map.isCoarse);
  EXPECT_LT(ErrorOn(scene, map), limits.tolerance);
  for (std::size_t p = 0; p < map.mesh.points.size(); ++p)
  {
    const glm::dvec3& at = map.mesh.points[p];
    if (at.z == 0.0 && p >= scene.floor.points.size()) // the map's own points are not new
    {
      // Rays from the rim start a thousandth of a cell within. Those from the shadow's border may
      // be lit or not.
      constexpr double Off = 3e-4;
      const double exact = scene.Exact(at.x, at.y);
      const auto isExact = [&](double x, double y)
      { return std::fabs(Light(map.front, p) - scene.Exact(x, y)) < Off * exact + 1e-9; };
      EXPECT_TRUE(isExact(at.x, at.y) || isExact(at.x + Off, at.y) || isExact(at.x - Off, at.y) ||
        isExact(at.x, at.y + Off) || isExact(at.x, at.y - Off))
        << at.x << ", " << at.y << ": " << Light(map.front, p) << " for " << exact;
    }
  }
}

// Facets along the shadow's border are as many as the border is long in shortest edges, which are
// as long as the square of the tolerance.
TEST(Adaptive, FacetsGatherAtTheBorder)
{
  const ShadowedFloor scene;
  const Surface black = Shapes::WithReflectance(scene.both, 0.0f);
  const auto facets = [&](double tolerance)
  {
    const RefinedMap map = Refined(black, scene.lamp, { tolerance });
    EXPECT_LT(ErrorOn(scene, map), tolerance);
    return static_cast<double>(map.mesh.facets.size());
  };
  const double some = facets(0.1), more = facets(0.05), most = facets(0.025);
  EXPECT_GT((most - more) / (more - some), 3.0);
  EXPECT_LT((most - more) / (more - some), 5.0);
}

TEST(Adaptive, NoMoreFacetsThanAllowed)
{
  const ShadowedFloor scene;
  const Surface black = Shapes::WithReflectance(scene.both, 0.0f);
  for (const std::uint64_t most : { 1u, 4u, 100u, 3000u })
  {
    const RefinedMap map = Refined(black, scene.lamp, { 0.05, most });
    EXPECT_TRUE(map.isCoarse);
    EXPECT_LE(map.mesh.facets.size(), std::max<std::uint64_t>(most, black.facets.size()));
    EXPECT_GT(map.mesh.facets.size(), 3 * most / 4);
    EXPECT_EQ(Gaps(black, map.mesh), 0u);
  }
}

TEST(Adaptive, NothingIsDividedWhereLightIsEven)
{
  for (const int cells : { 1, 60 })
  {
    const Surface floor = Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, cells);
    const RefinedMap sunny = Refined(floor, ParallelLight{ { 0.3, 0.1, -1.0 }, 1000.0 }, {});
    EXPECT_EQ(sunny.mesh.facets, floor.facets);
    EXPECT_EQ(sunny.mesh.points, floor.points);
  }
  // Walls that shine into a closed room (a furnace). Noise divides nothing, either.
  const Surface furnace = Shapes::WithReflectance(
    Shapes::WithExitance(Shapes::Box({ 0, 0, 0 }, { 1, 1, 1 }, 1, Facing::Inward), 100.0f), 0.5f);
  TraceSettings manyRays = Gathering();
  manyRays.gatherRays = 256;
  const RefinedMap even = Refined(furnace, EmittingFacets(), {}, manyRays, 300'000);
  EXPECT_EQ(even.mesh.facets, furnace.facets);
}

namespace
{

/// A room whose walls have points of their own, with a table and two lamps.
Surface Room()
{
  Surface room = Shapes::Together(Shapes::Box({ 0, 0, 0 }, { 4, 3, 2.5 }, 1, Facing::Inward),
    Shapes::Box({ 1, 1, 0.4 }, { 2, 2, 0.8 }, 1, Facing::Outward));
  room = Shapes::WithReflectance(room, 0.5f);
  room.materials.front().diffuseReflectance = Colour(0.7f, 0.5f, 0.3f);
  return room;
}

Lighting RoomLamps()
{
  Lighting lighting;
  lighting.luminaires.push_back({ PointLamp{ { 3.0, 2.2, 2.0 }, 500.0 }, "Point", Colour(1.0f) });
  lighting.luminaires.push_back(
    { DiskLamp{ { 2.0, 1.5, 2.4 }, { 0.0, 0.0, -1.0 }, 0.2, 500.0 }, "Disk", Colour(1.0f) });
  return lighting;
}

TraceSettings AllOutputs(int threads)
{
  TraceSettings settings = Gathering(threads);
  settings.registerBackSide = true;
  settings.lampsApart = true;
  return settings;
}

} // namespace

TEST(Adaptive, SameBitsForAnyNumberOfThreads)
{
  const RefinedMap one = Refined(Room(), RoomLamps(), { 0.2 }, AllOutputs(1));
  const RefinedMap two = Refined(Room(), RoomLamps(), { 0.2 }, AllOutputs(2));
  EXPECT_EQ(one.mesh.points, two.mesh.points);
  EXPECT_EQ(one.mesh.facets, two.mesh.facets);
  EXPECT_EQ(one.front.direct, two.front.direct);
  EXPECT_EQ(one.front.indirect, two.front.indirect);
  EXPECT_EQ(one.front.standardError, two.front.standardError);
  EXPECT_EQ(one.back.direct, two.back.direct);
  EXPECT_EQ(one.frontByColour, two.frontByColour);
  EXPECT_EQ(one.frontOfLamps, two.frontOfLamps);
}

TEST(Adaptive, WallsWithPointsOfTheirOwnStayClosed)
{
  const Surface room = Room();
  const RefinedMap map = Refined(room, RoomLamps(), { 0.2 });
  EXPECT_GT(map.mesh.facets.size(), 10 * room.facets.size());
  EXPECT_EQ(Gaps(room, map.mesh), 0u);
  EXPECT_EQ(RefinedMeshes::OpenEdges(map.mesh), 0u);
}

TEST(Adaptive, AllPartsOfTheLightAddUp)
{
  const Surface room = Room();
  const Scene scene(room);
  IlluminationRun run(scene, RoomLamps(), AllOutputs(0));
  run.Advance({ 20'000 });
  const RefinedMap map = *run.Refine(room, { 0.2 });
  const IlluminationMap given = run.Front();
  ASSERT_EQ(map.frontOfLamps.size(), 2u);
  ASSERT_EQ(map.frontByColour.size(), map.mesh.points.size());
  for (std::size_t p = 0; p < map.mesh.points.size(); ++p)
  {
    const double light = Light(map.front, p);
    double luminous = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      luminous += map.frontByColour[p][static_cast<std::size_t>(c)] * double{ LuminousWeights[c] };
    }
    EXPECT_NEAR(luminous, light, 1e-4 * light);
    EXPECT_NEAR(map.frontOfLamps[0][p] + map.frontOfLamps[1][p], light, 1e-4 * light);
    EXPECT_EQ(Light(map.back, p), 0.0) << "a closed room";
    EXPECT_TRUE(std::isfinite(map.front.standardError[p]));
    if (p < room.points.size())
    {
      EXPECT_EQ(map.mesh.points[p], room.points[p]);
      EXPECT_EQ(light, Light(given, p));
      EXPECT_EQ(map.front.photonHits[p], given.photonHits[p]);
    }
  }
}

// The sphere is traced in parts, which are then divided further where its shadow begins.
TEST(Adaptive, CurvedSurfacesKeepTheirShape)
{
  Surface given = Shapes::WithReflectance(Shapes::Icosphere(1, Facing::Outward), 0.0f);
  const Surface curved = CurvedSurface(given);
  const RefinedMap map = Refined(curved, ParallelLight{ { 0.0, 0.0, -1.0 }, 1000.0 }, {});
  EXPECT_GE(map.mesh.facets.size(), curved.facets.size());
  EXPECT_EQ(Gaps(given, map.mesh), 0u);
  for (std::size_t p = 0; p < map.mesh.points.size(); ++p)
  {
    const double radius = glm::length(map.mesh.points[p]);
    EXPECT_NEAR(radius, 1.0, 0.005);
    // Parts turn by 7 degrees, so their planes are half of that off: 1000 lx sin(3.5 degrees).
    EXPECT_NEAR(Light(map.front, p), 1000.0 * std::max(0.0, map.mesh.points[p].z / radius), 61.0);
  }
}

TEST(Adaptive, StoppedRefinementLeavesAValidMap)
{
  const Surface room = Room();
  const Scene scene(room);
  IlluminationRun run(scene, RoomLamps(), Gathering());
  run.Advance({ 20'000 });
  std::uint64_t all = 0;
  const RefinedMap whole = *run.Refine(room, { 0.2 },
    [&](std::uint64_t points)
    {
      all = points;
      return true;
    });
  for (const std::uint64_t end : { all / 100, 9 * all / 10 })
  {
    const RefinedMap map =
      *run.Refine(room, { 0.2 }, [&](std::uint64_t points) { return points < end; });
    EXPECT_EQ(Gaps(room, map.mesh), 0u);
    EXPECT_EQ(map.front.direct.size(), map.mesh.points.size());
    EXPECT_GE(map.mesh.points.size(), room.points.size());
    EXPECT_LT(map.mesh.points.size(), whole.mesh.points.size());
  }
}

TEST(Adaptive, RefusesLimitsOutOfRange)
{
  const ShadowedFloor scene;
  for (const double tolerance : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    EXPECT_THROW(Refined(scene.both, scene.lamp, { tolerance }), InvalidInput);
  }
  EXPECT_THROW(Refined(scene.both, scene.lamp, { 0.05, 0 }), InvalidInput);
}
