// SPDX-License-Identifier: BSD-3-Clause
// Where photons first arrive, against what the geometry says.
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint64_t Photons = 204'800;

Surface Box(Facing facing, float reflectance)
{
  return Shapes::WithReflectance(Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 3, facing), reflectance);
}

Surface WithMaterial(Surface surface, const Material& material)
{
  surface.materials = { material };
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  return surface;
}

std::vector<Arrivals> Trace(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings = {})
{
  const Scene scene(surface);
  IlluminationRun run(scene, lighting, settings);
  run.Advance({ Photons });
  const std::vector<Arrivals> arrivals = run.ArrivalsByLamp();
  std::uint64_t emitted = 0;
  for (const Arrivals& lamp : arrivals)
  {
    emitted += lamp.Emitted();
  }
  EXPECT_EQ(emitted, run.Balance().emitted);
  return arrivals;
}

/// @param probability Of a photon. Five standard deviations of independent photons.
void ExpectShare(std::uint64_t count, double probability)
{
  const auto photons = static_cast<double>(Photons);
  EXPECT_NEAR(static_cast<double>(count) / photons, probability,
    5.0 * std::sqrt(probability * (1.0 - probability) / photons));
}

} // namespace

TEST(Arrivals, RoomTakesAllOfItsLampOnFronts)
{
  const Arrivals lamp = Trace(Box(Facing::Inward, 0.5f), PointLamp{ { 0.1, 0.2, 0.3 } }).front();
  EXPECT_EQ(lamp.front, Photons);
}

TEST(Arrivals, RoomInsideOutTakesAllOfItOnBacks)
{
  const Arrivals lamp = Trace(Box(Facing::Outward, 0.5f), PointLamp{ { 0.1, 0.2, 0.3 } }).front();
  EXPECT_EQ(lamp.back, Photons);
}

// A point lamp above the middle of a square lights it through the solid angle of the square:
// 4 asin(a^2 / (a^2 + h^2)) of a half side a at a distance h.
TEST(Arrivals, FloorTakesTheSolidAngleThatItFills)
{
  constexpr double Pi = 3.14159265358979;
  const double share = std::asin(1.0 / (1.0 + 0.25)) / Pi;
  const Surface floor = Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 2);
  const Arrivals above = Trace(floor, PointLamp{ { 0, 0, 0.5 } }).front();
  ExpectShare(above.front, share);
  ExpectShare(above.escaped, 1.0 - share);
  const Arrivals below = Trace(floor, PointLamp{ { 0, 0, -0.5 } }).front();
  ExpectShare(below.back, share);
  ExpectShare(below.escaped, 1.0 - share);
}

// Half the light that a shade takes on its back leaves it diffusely, 0.3 of it outwards: that finds
// nothing; 0.2 of it inwards meets the back once more.
TEST(Arrivals, ShadeLetsItsLightPass)
{
  Material shade;
  shade.diffuseReflectance = Colour(0.2f);
  shade.diffuseTransmittance = Colour(0.3f);
  const Surface ball = WithMaterial(Shapes::Icosphere(2, Facing::Outward), shade);
  const Arrivals lamp = Trace(ball, PointLamp{ { 0, 0, 0 } }).front();
  EXPECT_EQ(lamp.front, 0u);
  EXPECT_EQ(lamp.back, 0u);
  ExpectShare(lamp.escaped, 0.3 / 0.8);
  ExpectShare(lamp.absorbed, 0.5 / 0.8);
}

// The same with transmission switched off: what would have passed is cut off.
TEST(Arrivals, WhatASwitchCutsOffHasNotArrived)
{
  Material shade;
  shade.diffuseTransmittance = Colour(0.3f);
  const Surface ball = WithMaterial(Shapes::Icosphere(2, Facing::Outward), shade);
  TraceSettings settings;
  settings.scatterings = AllScatterings & ~SetOf(Scattering::DiffuseTransmission);
  const Arrivals lamp = Trace(ball, PointLamp{ { 0, 0, 0 } }, settings).front();
  ExpectShare(lamp.cutOff, 0.3);
  ExpectShare(lamp.absorbed, 0.7);
}

// A body of glass with a lamp in it, in a room: all light arrives on the room's fronts in the end,
// or on the body's, when it comes back from the walls later; never on a back.
TEST(Arrivals, GlassBodyLetsItsLightOut)
{
  Surface surface = Box(Facing::Inward, 0.5f);
  const Surface ball = Shapes::Icosphere(2, Facing::Outward);
  const auto points = static_cast<std::uint32_t>(surface.points.size());
  const std::size_t walls = surface.facets.size();
  for (std::size_t p = 0; p < ball.points.size(); ++p)
  {
    surface.points.push_back(0.4 * ball.points[p]);
    surface.normals.push_back(ball.normals[p]);
  }
  for (const glm::uvec3& facet : ball.facets)
  {
    surface.facets.push_back(facet + points);
  }
  Material wall;
  wall.diffuseReflectance = Colour(0.5f);
  Material glass;
  glass.clearTransmittance = Colour(1.0f);
  glass.solid = true;
  surface.materials = { wall, glass };
  surface.materialOfFacet.assign(walls, 0);
  surface.materialOfFacet.resize(surface.facets.size(), 1);
  const Arrivals lamp = Trace(surface, PointLamp{ { 0.0, 0.0, 0.1 } }).front();
  EXPECT_EQ(lamp.back, 0u);
  EXPECT_EQ(lamp.escaped, 0u);
  EXPECT_EQ(lamp.front + lamp.absorbed + lamp.cutOff, Photons);
  EXPECT_GE(lamp.front, Photons * 99 / 100);
}

TEST(Arrivals, AreCountedByLamp)
{
  Lighting lighting;
  lighting.luminaires = { { PointLamp{ { 0, 0, 0 }, 300.0 }, "inside", Colour(1.0f) },
    { SpotLamp{ { 0, 0, 5 }, { 0, 0, 1 }, 0.3, 0.0, 100.0 }, "away", Colour(1.0f) },
    { SpotLamp{ { 0, 0, 5 }, { 0, 0, -1 }, 0.1, 0.0, 200.0 }, "behind", Colour(1.0f) } };
  const std::vector<Arrivals> lamps = Trace(Box(Facing::Inward, 0.5f), lighting);
  ASSERT_EQ(lamps.size(), 3u);
  EXPECT_EQ(lamps[0].front, lamps[0].Emitted());
  EXPECT_EQ(lamps[1].escaped, lamps[1].Emitted());
  EXPECT_EQ(lamps[2].back, lamps[2].Emitted());
  ExpectShare(lamps[0].Emitted(), 0.5);
  ExpectShare(lamps[1].Emitted(), 1.0 / 6.0);
}

// A target on a floor that is lit from below: no number of photons would meet it.
TEST(Run, TargetThatNothingCanMeetEndsTheRun)
{
  const Scene scene(Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2));
  IlluminationRun run(scene, PointLamp{ { 0.5, 0.5, -1.0 }, 10.0 }, TraceSettings());
  EXPECT_EQ(run.Advance({ 10'000'000'000, 0.01 }), StopReason::NothingLit);
  EXPECT_GE(run.Balance().emitted, MostPhotonsInTheDark);
  EXPECT_LE(run.Balance().emitted, 2 * MostPhotonsInTheDark);
  EXPECT_TRUE(run.CanGoOn());
  EXPECT_EQ(run.Advance({ 2 * MostPhotonsInTheDark }), StopReason::PhotonLimit); // without a target
}

// A share that just reaches the threshold exceeds it by three standard errors by chance alone in 1
// of 740 draws if photons are many, and never where they are too few to tell. One that is well
// above is found wherever photons are enough.
TEST(ShareOfLight, ExceedsAThresholdByMoreThanChance)
{
  std::mt19937 random(5);
  constexpr int Draws = 20'000;
  for (const double threshold : { 0.05, 0.1, 0.5, 0.99 })
  {
    for (const int photons : { 1, 3, 10, 100, 1000, 100'000 })
    {
      const auto frequency = [&](double share, double heavy)
      {
        std::binomial_distribution<int> light(photons, share), dark(photons / 10 + 1, share);
        int sure = 0;
        for (int i = 0; i < Draws; ++i)
        {
          const double a = light(random), b = dark(random), others = photons / 10 + 1;
          sure += ShareOfLight{ a + heavy * b, photons + heavy * others, a + heavy * heavy * b,
            photons + heavy * heavy * others }
                    .SurelyExceeds(threshold);
        }
        return sure / double{ Draws };
      };
      for (const double heavy : { 0.0, 1.0, 30.0 })
      {
        // A skewed binomial distribution exceeds three standard errors more often than a normal
        // one.
        EXPECT_LT(frequency(threshold, heavy), 0.012)
          << threshold << ' ' << photons << ' ' << heavy;
      }
      const double well = threshold + 0.5 * (1.0 - threshold);
      if (photons * (1.0 - threshold) >= 100)
      {
        EXPECT_GT(frequency(well, 1.0), 0.9) << threshold << ' ' << photons;
      }
    }
  }
  EXPECT_FALSE(ShareOfLight().SurelyExceeds(0.0));
  EXPECT_FALSE((ShareOfLight{ 8.0, 8.0, 8.0, 8.0 }.SurelyExceeds(0.5)));
  EXPECT_TRUE((ShareOfLight{ 10.0, 10.0, 10.0, 10.0 }.SurelyExceeds(0.5)));
}
