// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/materials/DiffuseReflections.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Warps.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

using namespace PhotonTransport;

namespace
{

/// Probability that a sound generator misses a test of this file: they never change, so once
/// passed they pass for ever.
constexpr double Significance = 1e-4;

/// chi^2 test of counts against the same expectation in every bin.
void ExpectUniform(const std::vector<int>& counts)
{
  double total = 0.0;
  for (const int count : counts)
  {
    total += count;
  }
  const double expected = total / static_cast<double>(counts.size());
  double statistic = 0.0;
  for (const int count : counts)
  {
    statistic += (count - expected) * (count - expected) / expected;
  }
  const boost::math::chi_squared distribution(static_cast<double>(counts.size()) - 1.0);
  EXPECT_GT(boost::math::cdf(boost::math::complement(distribution, statistic)), Significance);
}

/// Splits [0, 1)^2 into 2^a x 2^b boxes and counts the points of each.
std::vector<int> Boxes(const std::vector<std::array<std::uint32_t, 2>>& points, int a, int b)
{
  std::vector<int> counts(std::size_t{ 1 } << (a + b), 0);
  for (const auto& p : points)
  {
    const std::uint32_t x = a == 0 ? 0 : p[0] >> (32 - a);
    const std::uint32_t y = b == 0 ? 0 : p[1] >> (32 - b);
    ++counts[(std::size_t{ x } << b) | y];
  }
  return counts;
}

} // namespace

// Known answers published with Random123 (kat_vectors, philox4x32 with 7 rounds).
TEST(Philox, GivesThePublishedAnswers)
{
  using Block = std::array<std::uint32_t, 4>;
  EXPECT_EQ(Philox({ 0, 0, 0, 0 }, { 0, 0 }),
    (Block{ 0x5f6fb709u, 0x0d893f64u, 0x4f121f81u, 0x4f730a48u }));
}

TEST(Sobol, AdvancingAgreesWithJumping)
{
  SobolPoint point = SobolPointAt(1000);
  for (std::uint32_t index = 1000; index < 3000; ++index)
  {
    EXPECT_EQ(point, SobolPointAt(index));
    AdvanceSobolPoint(point, index);
  }
}

// The first 2^k points put one point into each of 2^k intervals, in every dimension, and Owen's
// scrambling keeps that.
TEST(Sobol, EachDimensionIsStratifiedBeforeAndAfterScrambling)
{
  constexpr int Bits = 10;
  for (unsigned d = 0; d < SobolDimensions; ++d)
  {
    for (const bool scramble : { false, true })
    {
      std::set<std::uint32_t> strata;
      for (std::uint32_t i = 0; i < (1u << Bits); ++i)
      {
        const std::uint32_t reversed = SobolPointAt(i)[d];
        // Seed 0 is the identity of the addition but not of the hash: any seed must do.
        const std::uint32_t value = OwenScramble(reversed, scramble ? 0x9e3779b9u * (d + 1) : 0u);
        strata.insert(value >> (32 - Bits));
      }
      EXPECT_EQ(strata.size(), std::size_t{ 1 } << Bits) << "dimension " << d;
    }
  }
}

// Dimensions 0 and 1 are a (0, 2)-sequence: every elementary box of area 2^-k gets one point.
TEST(Sobol, LeadingPairFillsElementaryBoxes)
{
  constexpr int Bits = 8;
  const SequenceKey key{ 7, 3, Sampling::Sobol };
  PhotonSequence sample(key, 0);
  std::vector<std::array<std::uint32_t, 2>> points;
  for (int i = 0; i < (1 << Bits); ++i, sample.Advance())
  {
    points.push_back({ sample.EmissionBits(0), sample.EmissionBits(1) });
  }
  for (int a = 0; a <= Bits; ++a)
  {
    for (const int count : Boxes(points, a, Bits - a))
    {
      EXPECT_EQ(count, 1);
    }
  }
}

TEST(PhotonSample, IsAFunctionOfTheIndexAlone)
{
  for (const Sampling sampling : { Sampling::Sobol, Sampling::Random })
  {
    const SequenceKey key{ 5, 2, sampling };
    PhotonSequence walking(key, 0xfffffff0u); // crosses 2^32, where the next sequence begins
    for (std::uint64_t index = 0xfffffff0u; index < 0x100000010u; ++index, walking.Advance())
    {
      const PhotonSequence jumped(key, index);
      for (unsigned d = 0; d < 5; ++d)
      {
        EXPECT_EQ(walking.EmissionBits(d), jumped.EmissionBits(d));
      }
      EXPECT_EQ(walking.Scatterings().At(0).survival, jumped.Scatterings().At(0).survival);
      EXPECT_EQ(walking.Scatterings().At(3).survival, jumped.Scatterings().At(3).survival);
    }
  }
}

TEST(PhotonSample, ManyTogetherAreThoseOneByOne)
{
  for (const Sampling sampling : { Sampling::Sobol, Sampling::Random })
  {
    // The second one crosses 2^32, where the next sequence begins.
    for (const std::uint64_t first : { std::uint64_t{ 7 }, std::uint64_t{ 0xfffffff0u } })
    {
      PhotonSequence together({ 5, 2, sampling }, first), single({ 5, 2, sampling }, first);
      for (const std::size_t count : { 1u, 13u, 64u, 0u, 2u })
      {
        std::vector<PhotonSample> taken(count);
        together.Take(taken.data(), count);
        for (std::size_t i = 0; i < count; ++i, single.Advance())
        {
          for (unsigned d = 0; d < SobolDimensions; ++d)
          {
            ASSERT_EQ(taken[i].EmissionBits(d), single.EmissionBits(d));
          }
          ASSERT_EQ(taken[i].Scatterings().At(3).survival, single.Scatterings().At(3).survival);
          for (const unsigned pair : { 0u, 1u })
          {
            const auto number = [&](unsigned d) { return single.Emission(2 * pair + d); };
            ASSERT_EQ(taken[i].OnDisk(pair), ConcentricDisk(number(0), number(1)));
            ASSERT_EQ(single.OnDisk(pair), ConcentricDisk(number(0), number(1)));
          }
        }
      }
      EXPECT_EQ(together.EmissionBits(6), single.EmissionBits(6));
    }
  }
}

TEST(ScatteringSamples, AreTheNumbersOfEachPhoton)
{
  const SequenceKey key{ 5, 2, Sampling::Sobol };
  const auto numbersOf = [&](std::size_t place)
  { return PhotonSequence(key, 0xffffffe0u + 3 * place).Scatterings(); };
  ScatteringSamples samples(key);
  for (const std::size_t count : { 64u, 0u, 1u, 11u })
  {
    for (std::size_t place = 0; place < count; ++place)
    {
      samples.Add(place, numbersOf(place), static_cast<std::uint32_t>(place % 5));
    }
    samples.Draw();
    for (std::size_t place = 0; place < count; ++place)
    {
      const ScatteringSample single = numbersOf(place).At(static_cast<std::uint32_t>(place % 5));
      ASSERT_EQ(samples[place].survival, single.survival);
      ASSERT_EQ(samples[place].u, single.u);
      ASSERT_EQ(samples[place].v, single.v);
    }
  }
}

TEST(DiffuseReflections, AreThoseOfSinglePhotons)
{
  PhotonSequence sample({ 9, 0, Sampling::Random }, 0);
  DiffuseReflections together;
  for (int batch = 0; batch < 1000; ++batch)
  {
    std::vector<glm::vec3> directions;
    const std::size_t count = batch % 2 == 0 ? DiffuseReflections::Most : 13;
    for (std::size_t i = 0; i < count; ++i, sample.Advance())
    {
      const glm::vec3 normal = UniformSphere(sample.Emission(0), sample.Emission(1));
      ScatteringSample numbers = sample.Scatterings().At(1);
      numbers.u = i % 7 == 0 ? 0.5f : numbers.u;
      numbers.v = i % 7 < 2 ? 0.5f : numbers.v; // the middle of the disk, too
      together.Add(normal, numbers);
      directions.push_back(ReflectDiffusely(normal, numbers.u, numbers.v));
    }
    std::size_t found = 0;
    together.Reflect([&](std::size_t place, const glm::vec3& direction)
      { found += place < count && direction == directions[place]; });
    ASSERT_EQ(found, count);
  }
}

TEST(PhotonSample, SeedsReplicatesAndOrdersDiffer)
{
  const PhotonSequence base({ 1, 0, Sampling::Sobol }, 99);
  EXPECT_NE(base.EmissionBits(0), PhotonSequence({ 2, 0, Sampling::Sobol }, 99).EmissionBits(0));
  EXPECT_NE(base.EmissionBits(0), PhotonSequence({ 1, 1, Sampling::Sobol }, 99).EmissionBits(0));
  EXPECT_NE(base.Scatterings().At(1).survival, base.Scatterings().At(2).survival);
  EXPECT_NE(base.Scatterings().At(1).survival,
    PhotonSequence({ 1, 1, Sampling::Sobol }, 99).Scatterings().At(1).survival);
}

// Joint uniformity of what one scattering uses, for independent numbers and for later scatterings.
TEST(PhotonSample, RandomNumbersFillTheSquare)
{
  for (const std::uint32_t order : { 0u, 1u, 7u })
  {
    PhotonSequence sample({ 11, 0, Sampling::Random }, 0);
    std::vector<int> counts(32 * 32, 0);
    for (int i = 0; i < 200000; ++i, sample.Advance())
    {
      const ScatteringSample s = sample.Scatterings().At(order);
      ++counts[static_cast<std::size_t>(s.u * 32.0f) * 32 + static_cast<std::size_t>(s.v * 32.0f)];
    }
    ExpectUniform(counts);
  }
}

namespace
{

/// Draws directions and counts them in bins of equal probability: by the cumulative distribution
/// of the cosine and by azimuth.
template <typename Warp, typename Cumulative>
void ExpectDistribution(const Warp& warp, const Cumulative& cumulativeOfCosine)
{
  constexpr int Polar = 20;
  constexpr int Around = 16;
  std::vector<int> counts(Polar * Around, 0);
  PhotonSequence sample({ 3, 0, Sampling::Random }, 0);
  for (int i = 0; i < 400000; ++i, sample.Advance())
  {
    const glm::vec3 direction = warp(sample.Emission(0), sample.Emission(1));
    ASSERT_NEAR(glm::length(direction), 1.0f, 2e-6f);
    const double below = std::clamp(cumulativeOfCosine(double{ direction.z }), 0.0, 1.0 - 1e-12);
    const double azimuth = std::atan2(direction.y, direction.x) / 6.283185307179586 + 0.5;
    const int bin = static_cast<int>(below * Polar) * Around +
      static_cast<int>(std::min(azimuth, 1.0 - 1e-12) * Around);
    ++counts[static_cast<std::size_t>(bin)];
  }
  ExpectUniform(counts);
}

} // namespace

TEST(Warps, CosineHemisphereFollowsLambert)
{
  ExpectDistribution(CosineHemisphere, [](double c) { return c * c; });
}

TEST(Warps, UniformSphereIsUniform)
{
  ExpectDistribution(UniformSphere, [](double c) { return 0.5 * (1.0 + c); });
}

TEST(Warps, PowerCosineConeFollowsItsDensity)
{
  for (const double exponent : { 0.0, 1.0, 4.5, 60.0 })
  {
    for (const double cosMax : { 0.0, 0.5, 0.99 })
    {
      const double edge = std::pow(cosMax, exponent + 1.0);
      ExpectDistribution([&](float u, float v)
        { return PowerCosineCone(u, v, static_cast<float>(exponent), static_cast<float>(cosMax)); },
        [&](double c) { return (std::pow(c, exponent + 1.0) - edge) / (1.0 - edge); });
    }
  }
}

TEST(Warps, TriangleIsUniform)
{
  std::vector<int> counts(4, 0); // the four triangles of half the size
  PhotonSequence sample({ 3, 0, Sampling::Random }, 0);
  for (int i = 0; i < 100000; ++i, sample.Advance())
  {
    const glm::vec2 b = UniformTriangle(sample.Emission(0), sample.Emission(1));
    ASSERT_LE(b.x + b.y, 1.0f);
    ++counts[b.x > 0.5f ? 0 : b.y > 0.5f ? 1 : b.x + b.y < 0.5f ? 2 : 3];
  }
  ExpectUniform(counts);
}
