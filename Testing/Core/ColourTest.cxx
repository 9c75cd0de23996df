// SPDX-License-Identifier: BSD-3-Clause
// Light by channel.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double LampFlux = 1000.0;
constexpr double Area = 24.0;
constexpr std::uint64_t Photons = 400'000;
constexpr double Weights[3] = { 0.2126, 0.7152, 0.0722 };

/// A closed cube of 24 m^2 of one diffuse reflectance.
Surface ClosedRoom(const Colour& reflectance)
{
  Surface room = Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 2, Facing::Inward);
  room.materials.assign(1, {});
  room.materials[0].diffuseReflectance = reflectance;
  room.materialOfFacet.assign(room.facets.size(), 0);
  return room;
}

/// A lamp of that colour, and a coloured one that is dark: it makes photons carry channels.
Lighting LampOf(const Colour& colour)
{
  Lighting lighting;
  lighting.luminaires.push_back({ PointLamp{ { 0.1, 0.2, 0.3 }, LampFlux }, "lamp", colour });
  lighting.luminaires.push_back({ PointLamp{ {}, 0.0 }, "dark", { 1.0f, 0.0f, 0.0f } });
  return lighting;
}

struct ColouredRun
{
  ColouredRun(const Surface& surface, const Lighting& lighting)
    : scene(surface)
    , run(scene, lighting, Settings())
  {
    this->run.Advance({ Photons });
    this->photons = static_cast<double>(this->run.Balance().emitted);
  }
  static TraceSettings Settings()
  {
    TraceSettings settings;
    settings.sampling = Sampling::Random; // standard errors are those of independent photons
    return settings;
  }
  /// Mean illuminance of each channel, lx.
  std::array<double, 3> Means() const
  {
    const auto byColour = this->run.FrontByColour();
    std::array<double, 3> means{};
    for (std::size_t v = 0; v < byColour.size(); ++v)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        means[c] += byColour[v][c] * this->scene.VertexAreas()[v] / Area;
      }
    }
    return means;
  }

  Scene scene;
  IlluminationRun run;
  double photons;
};

/// Each photon of a channel (a share s of them) has 1 + K hits, K >= k with probability rho^k: mean
/// 1 / (1 - rho), mean square (1 + rho) / (1 - rho)^2. So the sum of N photons' hits, as many being
/// of the channel as chance has it, is off by this relative to its mean.
double RelativeError(double share, double reflectance, double photons)
{
  return std::sqrt(((1.0 + reflectance) / share - 1.0) / photons);
}

} // namespace

TEST(Colour, WhiteLightInAWhiteRoomIsTheSameInEachChannel)
{
  const ColouredRun traced(ClosedRoom(Colour(0.6f)), LampOf(Colour(2.5f)));
  EXPECT_TRUE(traced.run.EffectsInUse().colour);
  EXPECT_FALSE(traced.run.EffectsInUse().colouredFacets);
  const double expected = LampFlux / (0.4 * Area);
  const std::array<double, 3> means = traced.Means();
  for (std::size_t c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(means[c] / expected, 1.0, 4.0 * RelativeError(Weights[c], 0.6, traced.photons))
      << c;
  }
}

// In integers, then turned into lux: a few roundings.
TEST(Colour, ChannelsMakeUpTheIlluminance)
{
  Surface room = ClosedRoom({ 0.8f, 0.5f, 0.1f });
  const ColouredRun traced(room, LampOf({ 1.0f, 0.7f, 0.3f }));
  const IlluminationMap front = traced.run.Front();
  const auto byColour = traced.run.FrontByColour();
  ASSERT_EQ(byColour.size(), front.direct.size());
  for (std::size_t v = 0; v < byColour.size(); ++v)
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum += double{ LuminousWeights[static_cast<int>(c)] } * byColour[v][c];
    }
    const double whole = front.direct[v] + front.indirect[v];
    EXPECT_NEAR(sum, whole, 16.0 * 0x1p-53 * whole);
  }
}

// E_c = Phi_c / ((1 - rho_c) S): the direct light and rho_c / (1 - rho_c) times as much.
TEST(Colour, ClosedRoomReflectsEachChannelByItself)
{
  const Colour reflectance(0.8f, 0.5f, 0.1f);
  for (const Colour& colour : { Colour(1.0f), Colour(1.0f, 0.5f, 0.25f), Colour(0.0f, 0.3f, 0.3f) })
  {
    const ColouredRun traced(ClosedRoom(reflectance), LampOf(colour));
    EXPECT_TRUE(traced.run.EffectsInUse().colouredFacets);
    const std::array<double, 3> means = traced.Means();
    const double luminous = Weights[0] * double{ colour.x } + Weights[1] * double{ colour.y } +
      Weights[2] * double{ colour.z };
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double strength = double{ colour[static_cast<int>(c)] } / luminous;
      const double rho = reflectance[static_cast<int>(c)];
      if (strength == 0.0)
      {
        EXPECT_EQ(means[c], 0.0);
        continue;
      }
      const double expected = LampFlux * strength / ((1.0 - rho) * Area);
      EXPECT_NEAR(
        means[c] / expected, 1.0, 4.0 * RelativeError(Weights[c] * strength, rho, traced.photons))
        << c;
    }
  }
}

TEST(Colour, FacetsShineInTheirOwn)
{
  Surface room = ClosedRoom(Colour(0.0f));
  room.exitance.assign(room.facets.size(), Colour(0.0f));
  room.exitance[0].x = 300.0f / LuminousWeights.x; // 300 lm/m^2 of red
  room.exitance[20].z = 100.0f / LuminousWeights.z;
  // Next to another lamp, so that facets are chosen within a share.
  Lighting lighting = EmittingFacets{};
  lighting.luminaires[0].colour = { 0.0f, 1.0f, 0.0f }; // facets have their own
  lighting.luminaires.push_back({ PointLamp{ {}, 50.0 }, "", { 0.0f, 1.0f, 0.0f } });
  const ColouredRun traced(room, lighting);
  const std::array<double, 3> means = traced.Means();
  const double fluxes[3] = { 300.0 * 0.5, 50.0, 100.0 * 0.5 }; // facets of half a square metre
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double flux = means[c] * Weights[c] * Area;
    EXPECT_NEAR(flux / fluxes[c], 1.0, 4.0 * RelativeError(fluxes[c] / 250.0, 0.0, traced.photons))
      << c;
  }
}

TEST(Colour, DarkOrWrongLightColoursAreRefused)
{
  const Scene scene(ClosedRoom(Colour(0.5f)));
  for (const Colour& colour :
    { Colour(0.0f), Colour(-1.0f, 1.0f, 1.0f), Colour(std::nanf("")), Colour(3e38f) })
  {
    EXPECT_THROW(Emitter(LampOf(colour), scene), std::runtime_error);
  }
}
