// SPDX-License-Identifier: BSD-3-Clause
// Bodies of glass: light is bent, and none is made or lost.
#include "PhotonTransport/transport/IlluminationRun.h"

#include "ClearMaterial.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Material Grey(float reflectance)
{
  Material material;
  material.diffuseReflectance = Colour(reflectance);
  return material;
}

/// A first surface of one material and a second of another.
Surface Together(const Surface& first, const Material& a, const Surface& second, const Material& b)
{
  Surface both = Shapes::Together(first, second);
  both.materials = { a, b };
  both.materialOfFacet.assign(both.facets.size(), 1);
  std::fill_n(both.materialOfFacet.begin(), first.facets.size(), 0u);
  return both;
}

/// Hits on the vertices [first, last), three a hit.
std::uint64_t HitsOf(const IlluminationMap& map, std::size_t first, std::size_t last)
{
  std::uint64_t hits = 0;
  for (std::size_t v = first; v < last; ++v)
  {
    hits += map.photonHits[v];
  }
  return hits / 3;
}

TraceSettings FlatSettings(std::uint32_t seed)
{
  TraceSettings settings;
  settings.seed = seed;
  settings.sampling = Sampling::Random;
  settings.registration = Registration::Flat;
  settings.registerBackSide = true;
  return settings;
}

} // namespace

class ClearBody : public testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(Dielectric, ClearBody, testing::Bool(),
  [](const auto& instance) { return instance.param ? "Solid" : "Panes"; });

// In a room of the same radiance everywhere, E = M / (1 - rho), a body that absorbs nothing changes
// nothing, neither on the walls nor on its own outside: Kirchhoff's furnace.
TEST_P(ClearBody, CannotBeSeenInAFurnace)
{
  const Surface walls =
    Shapes::WithExitance(Shapes::Box(glm::dvec3(-1.5), glm::dvec3(1.5), 2, Facing::Inward), 100.0f);
  const Surface ball = Shapes::Icosphere(2, Facing::Outward);
  const Scene scene(Together(walls, Grey(0.5f), ball, Clear(Colour(1.0f), 1.52f, GetParam())));
  const std::size_t points = scene.Vertices().size();
  double ballArea = 0.0;
  for (std::size_t v = walls.points.size(); v < points; ++v)
  {
    ballArea += scene.VertexAreas()[v];
  }
  constexpr std::uint32_t Runs = 12;
  double wallSum = 0.0, ballSum = 0.0, ballSquares = 0.0, photons = 0.0;
  for (std::uint32_t run = 0; run < Runs; ++run)
  {
    IlluminationRun traced(scene, EmittingFacets{}, FlatSettings(run + 1));
    traced.Advance({ 60'000 });
    const PhotonBalance balance = traced.Balance();
    EXPECT_EQ(balance.escaped, 0u);
    EXPECT_EQ(balance.emitted, balance.absorbed + balance.cutOff);
    // Rays that total reflection holds in the faceted ball find a facet that lets them out.
    EXPECT_EQ(balance.cutOff, 0u);
    const double luxPerHit = traced.Flux() / static_cast<double>(balance.emitted);
    const IlluminationMap front = traced.Front();
    const double onWalls = static_cast<double>(HitsOf(front, 0, walls.points.size()));
    const double onBall = static_cast<double>(HitsOf(front, walls.points.size(), points));
    wallSum += luxPerHit * onWalls / 54.0 / Runs;
    ballSum += luxPerHit * onBall / ballArea / Runs;
    ballSquares += std::pow(luxPerHit * onBall / ballArea, 2) / Runs;
    photons += static_cast<double>(balance.emitted);
  }
  // Hits of a photon on the walls are geometric, with mean 2 and variance 2.
  EXPECT_NEAR(wallSum / 200.0, 1.0, 4.0 * std::sqrt(2.0 / 4.0 / photons));
  // Student's t of 12 runs: 5 standard errors are exceeded once in 2500 times.
  const double error = std::sqrt((ballSquares - ballSum * ballSum) / (Runs - 1));
  EXPECT_NEAR(ballSum, 200.0, 5.0 * error);
  EXPECT_LT(error, 1.0);
}

// What a body absorbs is missing on the walls: with a transmittance below 1 photons end in it.
TEST_P(ClearBody, AbsorbsWhereItIsMeantTo)
{
  const Surface walls = Shapes::Box(glm::dvec3(-1.5), glm::dvec3(1.5), 1, Facing::Inward);
  const Surface ball = Shapes::Icosphere(2, Facing::Outward);
  const Lamp lamp = PointLamp{ { 1.2, 1.1, 1.0 }, 1000.0 };
  const auto absorbed = [&](float transmittance)
  {
    const Scene scene(
      Together(walls, Grey(1.0f), ball, Clear(Colour(transmittance), 1.3f, GetParam())));
    TraceSettings settings = FlatSettings(1);
    settings.maximumPathLength = 1000;
    IlluminationRun traced(scene, lamp, settings);
    traced.Advance({ 2048 });
    EXPECT_EQ(traced.Balance().escaped, 0u);
    return traced.Balance().absorbed;
  };
  EXPECT_EQ(absorbed(1.0f), 0u);
  EXPECT_EQ(absorbed(0.5f), 2048u);
}

// Light straight through a slab with all its reflections, which do not interfere:
// T = (1 - r) t / (1 + r) for a body that absorbs nothing inside, r = ((n - 1) / (n + 1))^2.
TEST(Dielectric, SlabTransmitsAsThePaneOfTheSameGlass)
{
  const Surface slab = Shapes::Box({ -1.0, -1.0, 0.5 }, { 1.0, 1.0, 0.8 }, 1, Facing::Outward);
  const Surface floor = Shapes::Rectangle({ -0.8, -0.8, 0 }, { 1.6, 0, 0 }, { 0, 1.6, 0 }, 1);
  const Surface pane = Shapes::Rectangle({ -1.0, -1.0, 0.5 }, { 2.0, 0, 0 }, { 0, 2.0, 0 }, 1);
  const double r = std::pow(0.52 / 2.52, 2);
  const auto expectTransmitted = [&](const Surface& glass, bool solid, float internal, double share)
  {
    const Scene scene(Together(floor, Grey(0.0f), glass, Clear(Colour(internal), 1.52f, solid)));
    IlluminationRun traced(scene, ParallelLight{ { 0.0, 0.0, -1.0 }, 1000.0 }, FlatSettings(1));
    traced.Advance({ 400'000 });
    const auto hits = static_cast<double>(HitsOf(traced.Front(), 0, floor.points.size()));
    const auto photons = static_cast<double>(traced.Balance().emitted);
    const double expected = 1000.0 * 1.6 * 1.6 * share / traced.Flux(); // of all photons
    EXPECT_NEAR(hits / photons, expected, 4.0 * std::sqrt(expected * (1.0 - expected) / photons));
    // What arrives straight through a pane is direct light, what was bent is not.
    const IlluminationMap front = traced.Front();
    EXPECT_EQ(front.indirect[0] == 0.0, !solid);
    EXPECT_EQ(front.direct[0] == 0.0, solid);
  };
  expectTransmitted(slab, true, 1.0f, (1.0 - r) / (1.0 + r));
  expectTransmitted(pane, false, 1.0f, (1.0 - r) / (1.0 + r));
  // A body's surface passes what is not reflected times its transmittance, on the way out too.
  const double t = 0.7f;
  expectTransmitted(slab, true, 0.7f, (1.0 - r) * t * (1.0 - r) * t / (1.0 - r * r));
  expectTransmitted(pane, false, 0.7f, (1.0 - r) * (1.0 - r) * t / (1.0 - r * r * t * t));
}
