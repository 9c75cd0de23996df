// SPDX-License-Identifier: BSD-3-Clause
// The roulette of a material.
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/materials/MaterialProperties.h"

#include "RandomNumbers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

using namespace PhotonTransport;

namespace
{

constexpr std::uint32_t LastBits = 0xffffffffu;
constexpr float LastFloat = 1.0f - 0x1p-24f; // the largest that UnitFloat gives
const glm::vec3 Normal(0.0f, 0.0f, 1.0f);
const glm::vec3 Straight(0.0f, 0.0f, -1.0f);
const glm::vec3 Slanted = glm::normalize(glm::vec3(0.6f, -0.3f, -0.7f));

Departure Scattered(const Roulette& roulette, const ScatteringSample& sample,
  const glm::vec3& direction, std::uint32_t channel = 0, bool front = true)
{
  return Scatter<AllScatterings>(
    roulette, roulette.channels[channel], sample, direction, Normal, front);
}

/// How many photons out of how many had what fate.
struct Fates
{
  static constexpr int Photons = 400'000;

  Fates(const Material& material, const glm::vec3& direction, bool front = true)
  {
    const Roulette roulette = MakeRoulette(material, false);
    RandomNumbers random(7);
    for (int i = 0; i < Photons; ++i)
    {
      const ScatteringSample sample{ random.Bits(), random.Unit(), random.Unit() };
      const Departure departure = Scattered(roulette, sample, direction, 0, front);
      if (departure.absorbed)
      {
        ++this->absorbed;
        continue;
      }
      EXPECT_NEAR(glm::length(departure.direction), 1.0f, 1e-6f);
      // Which side it is said to leave on is the side that its direction points to.
      EXPECT_EQ(glm::dot(departure.direction, Normal) >= 0.0f, departure.sameSide);
      auto& count = departure.sameSide ? this->back : this->through;
      ++count[static_cast<unsigned>(departure.how)];
    }
  }

  void Expect(const std::array<int, Scatterings>& counts, Scattering how, double share) const
  {
    ExpectCount(counts[static_cast<unsigned>(how)], share);
  }
  /// Binomial: four standard deviations.
  static void ExpectCount(int count, double share)
  {
    const double deviation = std::sqrt(Photons * share * (1.0 - share));
    EXPECT_NEAR(count, Photons * share, 4.0 * deviation) << share;
  }

  std::array<int, Scatterings> back{}, through{}; ///< Stay on their side; go to the other.
  int absorbed = 0;
};

Material Mixed()
{
  Material material;
  material.diffuseReflectance = Colour(0.3f);
  material.specularReflectance = Colour(0.2f);
  material.glossyReflectance = Colour(0.1f);
  material.diffuseTransmittance = Colour(0.15f);
  material.clearTransmittance = Colour(0.1f); // of the quarter that is left: 0.4
  material.roughness = 0.5f;
  material.refractiveIndex = 1.5f;
  return material;
}

/// Of index 1.5 at normal incidence.
constexpr double R = 0.04;

} // namespace

TEST(Scattering, FatesOfAPaneFollowTheShares)
{
  const Fates fates(Mixed(), Straight);
  fates.Expect(fates.back, Scattering::DiffuseReflection, 0.3);
  fates.Expect(fates.back, Scattering::SpecularReflection, 0.2);
  fates.Expect(fates.back, Scattering::GlossyReflection, 0.1);
  fates.Expect(fates.through, Scattering::DiffuseTransmission, 0.15);
  const double t = (1.0 - R) * (1.0 - R) * 0.4 / (1.0 - R * R * 0.16);
  const double r = R + R * 0.4 * t;
  fates.Expect(fates.back, Scattering::ClearTransmission, 0.25 * r);
  fates.Expect(fates.through, Scattering::ClearTransmission, 0.25 * t);
  fates.ExpectCount(fates.absorbed, 0.25 * (1.0 - r - t));
}

TEST(Scattering, FatesOfASolidFollowTheShares)
{
  Material material = Mixed();
  material.solid = true;
  for (const bool front : { true, false })
  {
    const Fates fates(material, Straight, front);
    fates.Expect(fates.back, Scattering::Refraction, 0.25 * R);
    fates.Expect(fates.through, Scattering::Refraction, 0.25 * (1.0 - R) * 0.4);
    fates.ExpectCount(fates.absorbed, 0.25 * (1.0 - R) * 0.6);
  }
  // Beyond the critical angle, 41.8 degrees, nothing leaves the body, but all of it comes back.
  const Fates trapped(material, Slanted, false);
  trapped.Expect(trapped.back, Scattering::Refraction, 0.25);
  EXPECT_EQ(trapped.through[static_cast<unsigned>(Scattering::Refraction)], 0);
  EXPECT_EQ(trapped.absorbed, 0);
}

// At the ends and the borders of the numbers, too.
TEST(Scattering, NoFateOfShareZeroIsTaken)
{
  for (const MaterialProperty& property : MaterialProperties)
  {
    const auto* member = std::get_if<Colour Material::*>(&property.member);
    if (!member)
    {
      continue;
    }
    for (const float share : { 1e-30f, 1e-9f, 0.5f, LastFloat, 1.0f })
    {
      Material material;
      material.** member = Colour(share, 0.0f, share);
      material.roughness = 1e-3f;
      const Roulette roulette = MakeRoulette(material, true);
      const auto edge = static_cast<std::uint32_t>(std::min(share * 0x1p32, 0x1p32 - 1.0));
      for (const std::uint32_t bits : { 0u, edge - 1u, edge, edge + 1u, LastBits })
      {
        for (const float u : { 0.0f, 0.5f, LastFloat })
        {
          const ScatteringSample sample{ bits, u, u };
          EXPECT_TRUE(Scattered(roulette, sample, Slanted, 1).absorbed)
            << property.name << ' ' << share;
          const Departure departure = Scattered(roulette, sample, Slanted, 0);
          EXPECT_TRUE(departure.absorbed || SetOf(departure.how) == ScatteringsOf(material))
            << property.name << ' ' << share << ' ' << bits;
          EXPECT_FALSE(share == 1.0f && departure.absorbed)
            << property.name << ' ' << bits << ' ' << u;
        }
      }
    }
  }
}

TEST(Scattering, NothingIsAbsorbedWhereTheSharesSumToOne)
{
  Material material;
  material.diffuseReflectance = Colour(0.1f);
  material.specularReflectance = Colour(0.2f);
  material.diffuseTransmittance = Colour(0.3f);
  material.clearTransmittance = Colour(0.4f);
  for (const bool solid : { false, true })
  {
    for (const float index : { 1.0f, 1.52f, 4.0f })
    {
      material.solid = solid;
      material.refractiveIndex = index;
      for (const glm::vec3& direction : { Straight, Slanted })
      {
        // 1 - 0.1 - 0.2 - 0.3 is 0.4 to three roundings of 2^-24: as many photons in 2^24 are lost.
        EXPECT_LE(Fates(material, direction).absorbed, 3);
      }
    }
  }
}

// A pane whose body passes one channel only is a mirror for the others by its faces.
TEST(Scattering, FacesOfAColouredPaneReflectAllColours)
{
  Material material;
  material.clearTransmittance = Colour(1.0f, 0.0f, 0.5f);
  material.refractiveIndex = 1.5f;
  const Roulette roulette = MakeRoulette(material, true);
  const auto at = [&](std::uint32_t channel, double u) {
    return Scattered(roulette, { 0u, static_cast<float>(u), 0.0f }, Straight, channel);
  };
  EXPECT_TRUE(at(1, R - 1e-3).sameSide);
  EXPECT_FALSE(at(1, R - 1e-3).absorbed);
  EXPECT_TRUE(at(1, R + 1e-3).absorbed);
  EXPECT_FALSE(at(0, R + R + 1e-3).absorbed);
  EXPECT_TRUE(at(0, R + R + 1e-3).undeflected);
  EXPECT_EQ(at(0, 0.5).direction, Straight);
  EXPECT_TRUE(at(2, 0.6).absorbed); // R + T = 0.04 + 0.46 + some
  EXPECT_FALSE(at(2, 0.49).absorbed);
}

TEST(Scattering, DiffuseAloneIsSurvivalToTheBit)
{
  RandomNumbers random(3);
  for (int i = 0; i < 100'000; ++i)
  {
    Material material;
    const float reflectance = i % 100 == 0 ? 1.0f : random.Unit();
    material.diffuseReflectance = Colour(reflectance);
    const auto edge = static_cast<std::uint32_t>(std::min(reflectance * 0x1p32f, 0x1.fffffep31f));
    const std::uint32_t bits = i % 3 == 0 ? random.Bits() : edge + random.Bits() % 3u - 1u;
    const ScatteringSample sample{ bits, random.Unit(), random.Unit() };
    const Departure departure = Scattered(MakeRoulette(material, i % 2 == 0), sample, Slanted, 2);
    ASSERT_EQ(departure.absorbed, !Survives(reflectance, bits)) << reflectance << ' ' << bits;
    if (!departure.absorbed)
    {
      ASSERT_EQ(departure.direction, ReflectDiffusely(Normal, sample.u, sample.v));
    }
  }
}

TEST(Scattering, LuminousSharesAreThoseOfEqualChannels)
{
  Material material;
  material.diffuseReflectance = { 0.8f, 0.4f, 0.2f };
  material.clearTransmittance = { 0.1f, 0.2f, 0.3f };
  const Roulette roulette = MakeRoulette(material, false);
  const double diffuse = 0.2126 * 0.8 + 0.7152 * 0.4 + 0.0722 * 0.2;
  const double clear = 0.2126 * 0.1 + 0.7152 * 0.2 + 0.0722 * 0.3;
  for (const RouletteChannel& channel : roulette.channels)
  {
    // Single precision: 4 roundings.
    EXPECT_NEAR(static_cast<double>(channel.diffuse) * 0x1p-32, diffuse, 0x1p-22);
    EXPECT_NEAR(channel.internal, clear / (1.0 - diffuse), 0x1p-21);
  }
}

TEST(Scattering, WhatAMaterialCanDoIsKnown)
{
  Material material;
  EXPECT_EQ(ScatteringsOf(material), 0u);
  EXPECT_EQ(ScatteringsOf(Mixed()), AllScatterings & ~SetOf(Scattering::Refraction));
  material.clearTransmittance = { 0.0f, 0.0f, 1e-30f };
  EXPECT_EQ(ScatteringsOf(material), SetOf(Scattering::ClearTransmission));
  EXPECT_TRUE(IsColoured(material));
  EXPECT_FALSE(IsColoured(Mixed()));
  material.solid = true;
  EXPECT_EQ(ScatteringsOf(material), SetOf(Scattering::Refraction));
}
