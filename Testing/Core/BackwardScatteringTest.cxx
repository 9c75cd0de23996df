// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a ray at one facet, followed against the light.
#include "PhotonTransport/materials/BackwardScattering.h"

#include "ClearMaterial.h"
#include "RandomNumbers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

using namespace PhotonTransport;

namespace
{

constexpr float LastFloat = 1.0f - 0x1p-24f; // the largest that UnitFloat gives
const glm::vec3 Normal(0.0f, 0.0f, 1.0f);

/// Shares of at least 0.02 that leave as much to the clear part and to absorption.
Material RandomMaterial(RandomNumbers& random, bool grey, bool solid)
{
  const auto colour = [&]()
  {
    const float red = random.Unit(), green = random.Unit(), blue = random.Unit();
    return grey ? Colour(0.02f + 0.17f * red) : 0.02f + 0.17f * Colour(red, green, blue);
  };
  Material material = Clear(colour(), 1.0f + random.Unit(), solid);
  material.diffuseReflectance = colour();
  material.specularReflectance = colour();
  material.glossyReflectance = colour();
  material.diffuseTransmittance = colour();
  material.roughness = 0.1f + 0.9f * random.Unit();
  return material;
}

ScatteringSample RandomSample(RandomNumbers& random)
{
  ScatteringSample sample{ random.Bits(), random.Unit(), 0.0f };
  sample.v = random.Unit();
  return sample;
}

glm::vec3 Arriving(RandomNumbers& random)
{
  const float u = random.Unit();
  return -CosineHemisphere(u, random.Unit());
}

/// What radiance is divided by: the square of the index of the side that a ray has gone to,
/// relative to that of the side it comes from.
float DivisorOf(const FollowedRay& ray, const Roulette& material, bool front)
{
  const float index = front ? material.refractiveIndex : 1.0f / material.refractiveIndex;
  return ray.how == Scattering::Refraction && !ray.sameSide ? index * index : 1.0f;
}

/// Fresnel's reflectance of a surface of index n for light by Lambert's law from outside; Walsh
/// 1926, in Duntley, "The Optical Properties of Diffusing Materials", JOSA 32(2), 1942.
double DiffuseFresnelReflectance(double n)
{
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * std::pow(n + 1.0, 2)) +
    n2 * std::pow(n2 - 1.0, 2) / std::pow(n2 + 1.0, 3) * std::log((n - 1.0) / (n + 1.0)) -
    2.0 * n * n2 * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
    8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * std::pow(n4 - 1.0, 2)) * std::log(n);
}

} // namespace

// Where all channels are alike a ray does what a photon does with the same numbers.
TEST(BackwardScattering, FollowsGreyMaterialsAsPhotonsDoToTheBit)
{
  RandomNumbers random(1);
  for (int i = 0; i < 100'000; ++i)
  {
    const bool colour = i % 3 == 0;
    const Roulette material = MakeRoulette(RandomMaterial(random, colour, i % 2 == 0), colour);
    const ScatteringSample sample = RandomSample(random);
    const glm::vec3 direction = Arriving(random);
    const bool front = i % 5 < 3;
    const Departure photon =
      Scatter<AllScatterings>(material, material.channels[1], sample, direction, Normal, front);
    const FollowedRay ray = FollowBack(material, sample, direction, Normal, front);
    ASSERT_EQ(ray.goesOn, !photon.absorbed);
    if (ray.goesOn)
    {
      ASSERT_EQ(ray.how, photon.how);
      ASSERT_EQ(ray.sameSide, photon.sameSide);
      ASSERT_EQ(ray.undeflected, photon.undeflected);
      ASSERT_EQ(ray.direction, photon.direction);
      ASSERT_EQ(ray.weight, Colour(1.0f) / DivisorOf(ray, material, front));
    }
  }
}

// White light keeps its luminance at each step, so no channel gains more than 1 / LuminousWeights.
TEST(BackwardScattering, WeightsAreBoundedAndTheirLuminousMeanIsOne)
{
  RandomNumbers random(2);
  std::array<int, Scatterings> counts{};
  for (int i = 0; i < 100'000; ++i)
  {
    const Roulette material = MakeRoulette(RandomMaterial(random, false, i % 2 == 0), true);
    const bool front = i % 5 < 3;
    const FollowedRay ray =
      FollowBack(material, RandomSample(random), Arriving(random), Normal, front);
    if (ray.goesOn)
    {
      ++counts[static_cast<unsigned>(ray.how)];
      const Colour parts = LuminousWeights * ray.weight * DivisorOf(ray, material, front);
      // Shares of 0.02 are counts of 2^32 to 1.2e-8; 8 roundings of 2^-24.
      ASSERT_NEAR(parts.x + parts.y + parts.z, 1.0f, 5e-7f);
      ASSERT_GE(std::min({ parts.x, parts.y, parts.z }), 0.0f);
    }
  }
  for (const int count : counts)
  {
    EXPECT_GT(count, 1000);
  }
}

// At the ends and the borders of the numbers, in the plane of the facet, with shares of 0.
TEST(BackwardScattering, IsSoundAtTheEdges)
{
  const std::array<Colour, 5> colours{ Colour(0.0f), Colour(1e-30f, 0.0f, 1e-9f),
    Colour(0.0f, 0.0f, 1.0f), Colour(0.2f, LastFloat, 1.0f), Colour(1.0f) };
  for (const Colour& share : colours)
  {
    for (const bool solid : { false, true })
    {
      std::array<Material, 3> materials{ Clear(share, 1.5f, solid), Clear(share, 1.0f, solid), {} };
      materials[2].glossyReflectance = share;
      materials[2].specularReflectance = Colour(1.0f) - share;
      for (const Material& material : materials)
      {
        for (const float cosine : { 0.0f, 1e-30f, 1e-7f, 1e-3f, 1.0f })
        {
          const glm::vec3 direction(std::sqrt((1.0f - cosine) * (1.0f + cosine)), 0.0f, -cosine);
          for (const std::uint32_t bits : { 0u, 1u, 0x33333333u, 0x33333334u, 0xffffffffu })
          {
            for (const float u : { 0.0f, 0.04f, 0.5f, LastFloat })
            {
              const FollowedRay ray = FollowBack(
                MakeRoulette(material, true), { bits, u, u }, direction, Normal, u < 0.5f);
              if (ray.goesOn)
              {
                EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f); // NaN fails
              }
              for (int c = 0; c < 3; ++c)
              {
                EXPECT_GE(ray.weight[c], 0.0f);
                // Shares of few counts of 2^32 round to half of themselves; 2.25 is n^2.
                EXPECT_LE(ray.weight[c], 2.0f * 2.25f / LuminousWeights[c]);
              }
            }
          }
        }
      }
    }
  }
}

// A receiver in a body, parallel to its surface, gets what the surface lets in of a uniform
// radiance L outside: E = pi L (1 - R), R for light by Lambert's law. Without n^2 it would be less
// by that factor. Outside, radiance L in the body gives E = pi L (1 - R) / n^2.
TEST(BackwardScattering, RadianceGoesByTheSquareOfTheIndex)
{
  constexpr int Rays = 400'000;
  for (const float index : { 1.33f, 1.5f, 2.4f })
  {
    const Roulette material = MakeRoulette(Clear(Colour(1.0f), index, true), false);
    const double n = double{ index };
    const double passed = 1.0 - DiffuseFresnelReflectance(n);
    for (const bool intoBody : { false, true })
    {
      RandomNumbers random(4);
      int through = 0;
      const float weight = intoBody ? 1.0f / (index * index) : index * index;
      for (int i = 0; i < Rays; ++i)
      {
        const FollowedRay ray =
          FollowBack(material, RandomSample(random), Arriving(random), Normal, intoBody);
        ASSERT_TRUE(ray.goesOn);
        through += ray.sameSide ? 0 : 1;
        ASSERT_NEAR(ray.weight.y, ray.sameSide ? 1.0f : weight, 4.0f * 0x1p-24f * weight);
      }
      const double expected = intoBody ? passed / (n * n) : passed; // E / (pi L)
      const double share = expected / double{ weight };
      const double deviation = std::sqrt(share * (1.0 - share) / Rays);
      EXPECT_NEAR(double{ weight } * through / Rays, expected, 4.0 * double{ weight } * deviation)
        << index << ' ' << intoBody;
    }
  }
}

TEST(BackwardScattering, PaneTransmittanceIsTheShareOfPhotonsThatGoStraightOn)
{
  constexpr int Photons = 200'000;
  RandomNumbers random(5);
  for (const bool colour : { false, true })
  {
    for (const float cosine : { 0.1f, 0.5f, 1.0f })
    {
      const Roulette material = MakeRoulette(RandomMaterial(random, false, false), colour);
      const Colour transmittance = PaneTransmittance(material, cosine);
      const glm::vec3 direction(std::sqrt(1.0f - cosine * cosine), 0.0f, -cosine);
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        int straight = 0;
        for (int i = 0; i < Photons; ++i)
        {
          const Departure photon = Scatter<AllScatterings>(
            material, material.channels[c], RandomSample(random), direction, Normal, i % 2 == 0);
          straight += !photon.absorbed && photon.undeflected ? 1 : 0;
        }
        const double share = double{ transmittance[static_cast<int>(c)] };
        const double deviation = std::sqrt(share * (1.0 - share) / Photons);
        EXPECT_NEAR(double(straight) / Photons, share, 4.0 * deviation) << cosine << ' ' << c;
      }
    }
  }
}

// Glass of index 1.5 and internal transmittances t: T = (1 - r)^2 t / (1 - r^2 t^2), r = 0.04.
TEST(BackwardScattering, PaneTransmittanceIsThatOfGlass)
{
  const Colour internal(1.0f, 0.5f, 0.0f);
  const Colour pane = PaneTransmittance(MakeRoulette(Clear(internal, 1.5f, false), true), 1.0f);
  for (int c = 0; c < 3; ++c)
  {
    const double t = double{ internal[c] };
    EXPECT_NEAR(pane[c], 0.96 * 0.96 * t / (1.0 - 0.0016 * t * t), 8 * 0x1p-24);
  }
  EXPECT_EQ(PaneTransmittance(MakeRoulette(Clear(internal, 1.5f, true), true), 1.0f), Colour(0.0f));
  Material matt;
  matt.diffuseReflectance = Colour(0.3f);
  EXPECT_EQ(PaneTransmittance(MakeRoulette(matt, true), 1.0f), Colour(0.0f));
}
