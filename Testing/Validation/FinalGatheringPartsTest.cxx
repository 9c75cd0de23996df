// SPDX-License-Identifier: BSD-3-Clause
// The parts of which the second pass makes up light: caustics are those of photon tracing, and what
// is kept apart adds up.
#include "Comparison.h"
#include "GatheringTools.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Material Glass()
{
  Material glass;
  glass.clearTransmittance = Colour(1.0f);
  glass.refractiveIndex = 1.5f;
  glass.solid = true;
  return glass;
}

/// A floor, and a ball above it that is something else.
Surface BallOverFloor(const Material& ball, const Material& floor)
{
  Surface sphere = Shapes::Icosphere(3, Facing::Outward);
  for (glm::dvec3& point : sphere.points)
  {
    point = 0.5 * point + glm::dvec3(0.0, 0.0, 1.0);
  }
  const Surface below = Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 24);
  Surface both = Shapes::Together(below, sphere);
  both.materials = { floor, ball };
  both.materialOfFacet.assign(both.facets.size(), 1);
  std::fill_n(both.materialOfFacet.begin(), below.facets.size(), 0u);
  return both;
}

double FluxOf(const Scene& scene, const std::vector<double>& map)
{
  double flux = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    flux += scene.VertexAreas()[v] * map[v];
  }
  return flux;
}

} // namespace

// On black ground all light that is not direct is caustic, and the same photons bring it.
TEST(FinalGathering, CausticOfAGlassSphereIsThatOfPhotonTracing)
{
  constexpr std::uint64_t Photons = 100'000;
  const Scene scene(BallOverFloor(Glass(), Material()));
  const ParallelLight sun{ { 0.2, 0.1, -1.0 }, 1000.0 };
  TraceSettings settings = GatheringSettings(16);
  const IlluminationMap gathered = GatheredFront(scene, sun, settings, Photons);
  settings.method = Method::PhotonTracing;
  const IlluminationMap traced = GatheredFront(scene, sun, settings, Photons);
  EXPECT_EQ(gathered.caustic, traced.indirect);
  EXPECT_EQ(gathered.indirect, gathered.caustic) << "black facets send nothing";
  const double flux = FluxOf(scene, gathered.caustic);
  std::printf("  caustic of %.1f lm\n", flux);
  // Of the light that meets the sphere most passes it twice: (1 - 0.04)^2, less beside its middle.
  const double met = 1000.0 * 3.14159265358979 * 0.25;
  EXPECT_GT(flux, 0.7 * met);
  EXPECT_LT(flux, met);
}

// Other photons from matt ground meet the sphere, too: its caustics on a wall add to those of the
// lamp. All light on the floor is the same as that of photons, within errors.
TEST(FinalGathering, MattGroundUnderAGlassSphereHasTheFluxOfPhotonTracing)
{
  Material matt;
  matt.diffuseReflectance = Colour(0.5f);
  const Scene scene(BallOverFloor(Glass(), matt));
  const RectangleLamp panel{ { 0.2, 0.1, 3.0 }, { 0, 0, -1 }, 0.5, 0.5, 1000.0 };
  std::vector<double> caustic, indirect;
  for (std::uint32_t seed = 1; seed <= 16; ++seed)
  {
    TraceSettings settings = GatheringSettings(64, seed);
    const IlluminationMap gathered = GatheredFront(scene, panel, settings, 50'000);
    settings.method = Method::PhotonTracing;
    settings.seed += 100;
    const IlluminationMap traced = GatheredFront(scene, panel, settings, 50'000);
    indirect.push_back(FluxOf(scene, gathered.indirect) - FluxOf(scene, traced.indirect));
    caustic.push_back(FluxOf(scene, gathered.caustic));
  }
  const MeanAndError difference = MeanOf(indirect);
  std::printf("  indirect flux %+.3f +- %.3f lm against photon tracing, caustic %.2f lm\n",
    difference.mean, difference.error, MeanOf(caustic).mean);
  EXPECT_LT(std::fabs(difference.mean), 4.0 * difference.error);
  EXPECT_GT(MeanOf(caustic).mean, 10.0 * difference.error) << "it would not be missed";
}

// What leaves a cell is kept in single precision, once for all lamps together and once by lamp. On
// the way to a sum either takes a few roundings of 2^-24, all of one sign at worst.
TEST(FinalGathering, LampsColoursAndPartsAddUp)
{
  constexpr double Rounding = 8.0 * 0x1p-24;
  Surface room = Shapes::Together(
    Shapes::Box({ -1, -1, 0 }, { 1, 1, 2 }, 4, Facing::Inward), BallOverFloor(Glass(), Material()));
  Material coloured, mirror, gloss;
  coloured.diffuseReflectance = Colour(0.7f, 0.4f, 0.2f);
  mirror.specularReflectance = Colour(0.8f);
  gloss.glossyReflectance = Colour(0.3f, 0.5f, 0.4f);
  gloss.diffuseReflectance = Colour(0.3f);
  const std::size_t walls = 6 * 2 * 4 * 4;
  room.materialOfFacet.resize(room.facets.size());
  room.materials = { coloured, mirror, gloss, Glass() };
  for (std::size_t f = 0; f < room.facets.size(); ++f)
  {
    const bool isBall = f >= walls + 2 * 24 * 24;
    room.materialOfFacet[f] = isBall ? 3 : f < walls ? static_cast<std::uint32_t>(f / 32 % 3) : 0;
  }
  Lighting lighting;
  lighting.luminaires = { { PointLamp{ { 0.5, 0.4, 1.5 }, 300.0 }, "red", { 1.0f, 0.2f, 0.1f } },
    { RectangleLamp{ { -0.3, 0, 1.9 }, { 0, 0, -1 }, 0.5, 0.5, 700.0 }, "panel", Colour(1.0f) },
    { UniformSky{ { 0, 0, 1 }, 100.0, true }, "sky that does not get in", Colour(1.0f) } };
  const Scene scene(room);
  TraceSettings settings = GatheringSettings(64);
  settings.lampsApart = true;
  IlluminationRun run(scene, lighting, settings);
  run.Advance({ 50'000 });
  const IlluminationMap map = run.Front();
  const std::vector<std::array<double, 3>> colours = run.FrontByColour();
  ASSERT_EQ(colours.size(), map.direct.size());
  double caustics = 0.0;
  double differs = 0.0;
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    const double whole = map.direct[v] + map.indirect[v];
    double lamps = 0.0;
    for (std::size_t lamp = 0; lamp < lighting.luminaires.size(); ++lamp)
    {
      lamps += run.FrontOfLamp(lamp)[v];
    }
    double luminous = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      luminous += double{ LuminousWeights[c] } * colours[v][static_cast<std::size_t>(c)];
    }
    EXPECT_NEAR(lamps, whole, Rounding * whole) << v;
    EXPECT_NEAR(luminous, whole, Rounding * whole) << v;
    EXPECT_LE(map.caustic[v], map.indirect[v]) << v;
    caustics += map.caustic[v];
    differs += std::fabs(colours[v][0] - colours[v][2]);
  }
  EXPECT_GT(caustics, 0.0);
  EXPECT_GT(differs, 0.0);
}
