// SPDX-License-Identifier: BSD-3-Clause
// Light of all channels at facets, against light of one channel.
#include "RandomNumbers.h"

#include "PhotonTransport/materials/ColourScattering.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/transport/Flight.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

using namespace PhotonTransport;

const glm::vec3 Normal(0.0f, 0.0f, 1.0f);
constexpr std::size_t Ways = 2 * Scatterings;
using ByChannel = std::array<double, 3>;

Colour RandomColour(RandomNumbers& random)
{
  const float red = random.Unit(), green = random.Unit();
  return { red, green, random.Unit() };
}

/// Does everything, in colours; as a pane or as the surface of a body.
Material RandomMaterial(RandomNumbers& random)
{
  Material material;
  constexpr float Each = 0.2f; // five of them are at most 1
  for (const auto share :
    { &Material::diffuseReflectance, &Material::specularReflectance, &Material::glossyReflectance,
      &Material::diffuseTransmittance, &Material::clearTransmittance })
  {
    material.*share = Each * RandomColour(random);
  }
  material.roughness = 0.1f + 0.9f * random.Unit();
  material.refractiveIndex = 1.0f + random.Unit();
  material.solid = random.Unit() < 0.5f;
  return material;
}

ScatteringSample RandomSample(RandomNumbers& random)
{
  ScatteringSample sample{ random.Bits(), random.Unit(), 0.0f };
  sample.v = random.Unit();
  return sample;
}

std::size_t WayOf(const Departure& departure)
{
  return 2 * static_cast<std::size_t>(departure.how) + (departure.sameSide ? 1 : 0);
}

PhotonOrigin PhotonOf(const Colour& colour)
{
  PhotonOrigin photon;
  photon.shares = colour / (colour.x + colour.y + colour.z);
  return photon;
}

} // namespace

TEST(ColourScattering, EachChannelTakesEachWayAsOftenAsAlone)
{
  constexpr int Photons = 20'000;
  RandomNumbers random(5);
  for (int i = 0; i < 40; ++i)
  {
    const Roulette material = MakeRoulette(RandomMaterial(random), true);
    const PhotonOrigin start = PhotonOf(RandomColour(random) + 0.01f);
    const bool front = random.Unit() < 0.5f;
    const glm::vec3 direction = -CosineHemisphere(random.Unit(), random.Unit());
    std::array<ByChannel, Ways> together{}, squares{}, alone{};
    for (int n = 0; n < Photons; ++n)
    {
      PhotonOrigin photon = start;
      const Departure departure = ScatterPhoton<AllScatterings>(
        material, photon, RandomSample(random), direction, Normal, front);
      EXPECT_NEAR(photon.shares.x + photon.shares.y + photon.shares.z, 1.0f, 4.0f * 0x1p-24f);
      for (int c = 0; c < 3; ++c)
      {
        const double light = departure.absorbed ? 0.0 : double{ photon.shares[c] };
        const auto channel = static_cast<std::size_t>(c);
        together[WayOf(departure)][channel] += light;
        squares[WayOf(departure)][channel] += light * light;
        const Departure one = Scatter<AllScatterings>(
          material, material.channels[channel], RandomSample(random), direction, Normal, front);
        alone[WayOf(one)][channel] += one.absorbed ? 0.0 : 1.0;
      }
    }
    for (std::size_t way = 0; way < Ways; ++way)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double share{ start.shares[static_cast<int>(c)] };
        const double variance = squares[way][c] + share * share * (alone[way][c] + 1.0);
        // 1440 differences of sums of independent numbers: all within 5 standard deviations.
        EXPECT_NEAR(together[way][c], share * alone[way][c], 5.0 * std::sqrt(variance))
          << "material " << i << ", way " << way << ", channel " << c;
      }
    }
  }
}

// Along a path the shares are those with which the channels alone would have taken it.
TEST(ColourScattering, SharesFollowTheReflectancesOnAPath)
{
  RandomNumbers random(9);
  for (int i = 0; i < 1000; ++i)
  {
    PhotonOrigin photon = PhotonOf(RandomColour(random));
    glm::dvec3 expected(photon.shares);
    for (int scattering = 0; scattering < 8; ++scattering)
    {
      Material wall;
      wall.diffuseReflectance = RandomColour(random);
      if (scattering == 4 && i % 4 == 0)
      {
        wall.diffuseReflectance.z = 0.0f;
      }
      const Roulette roulette = MakeRoulette(wall, true);
      const ScatteringSample goesOn{ 0, random.Unit(), random.Unit() };
      ASSERT_FALSE(
        ScatterPhoton<AllScatterings>(roulette, photon, goesOn, -Normal, Normal, true).absorbed);
      expected *= glm::dvec3(wall.diffuseReflectance);
    }
    expected /= expected.x + expected.y + expected.z;
    for (int c = 0; c < 3; ++c)
    {
      // Eight times: a reflectance is rounded to 2^-32, a weight and a share to single precision.
      EXPECT_NEAR(double{ photon.shares[c] }, expected[c], 8.0 * 4.0 * 0x1p-24) << i;
    }
    EXPECT_TRUE(i % 4 != 0 || photon.shares.z == 0.0f);
  }
}

TEST(ColourScattering, GreyFacetsLeaveTheColourOfLight)
{
  Material grey;
  grey.diffuseReflectance = Colour(0.3f);
  grey.clearTransmittance = Colour(0.5f);
  RandomNumbers random(2);
  const PhotonOrigin start = PhotonOf({ 0.1f, 0.7f, 0.3f });
  for (int i = 0; i < 1000; ++i)
  {
    PhotonOrigin photon = start;
    ScatterPhoton<AllScatterings>(
      MakeRoulette(grey, true), photon, RandomSample(random), -Normal, Normal, true);
    EXPECT_EQ(photon.shares, start.shares);
  }
}
