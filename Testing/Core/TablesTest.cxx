// SPDX-License-Identifier: BSD-3-Clause
// Choices by tables: of directions, and among many.
#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/FluxTable.h"

#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace PhotonTransport;

// Cell by cell of a solid of random intensities, some 0, by Pearson's chi^2.
TEST(DirectionTable, SamplesItsDensity)
{
  constexpr int Draws = 100'000;
  RandomNumbers random(2);
  const std::vector<double> polar{ 0.1, 0.3, 0.9, 1.0, 2.0, 3.0 };
  const std::vector<double> azimuth{ -0.5, 0.0, 1.0, 1.1, 4.0 };
  std::vector<double> values;
  for (std::size_t i = 0; i < polar.size() * azimuth.size(); ++i)
  {
    values.push_back(i % 4 == 1 ? 0.0 : random.Unit());
  }
  const DirectionTable table(polar, azimuth, values);
  const auto cellIntegral = [&](std::size_t z, std::size_t p)
  {
    std::vector<double> corners;
    for (const std::size_t plane : { z, z + 1 })
    {
      corners.push_back(values[plane * polar.size() + p]);
      corners.push_back(values[plane * polar.size() + p + 1]);
    }
    return DirectionTable({ polar[p], polar[p + 1] }, { azimuth[z], azimuth[z + 1] }, corners)
      .Integral();
  };
  // Halves of cells too: within them the density is not even.
  std::vector<int> counts(4 * 5 * 4, 0);
  for (int i = 0; i < Draws; ++i)
  {
    const double u = random.Unit();
    const glm::dvec2 angles = table.Sample(u, random.Unit());
    ASSERT_TRUE(angles.x >= 0.1 && angles.x <= 3.0 && angles.y >= -0.5 && angles.y <= 4.0);
    std::size_t p = 0, z = 0;
    while (angles.x > polar[p + 1])
    {
      ++p;
    }
    while (angles.y > azimuth[z + 1])
    {
      ++z;
    }
    ++counts[z * 5 + p];
  }
  double chi2 = 0.0, sum = 0.0;
  for (std::size_t z = 0; z < 4; ++z)
  {
    for (std::size_t p = 0; p < 5; ++p)
    {
      const double integral = cellIntegral(z, p);
      const double mean = Draws * integral / table.Integral();
      sum += integral;
      ASSERT_GT(mean, 5.0);
      chi2 += std::pow(counts[z * 5 + p] - mean, 2) / mean;
    }
  }
  EXPECT_NEAR(sum, table.Integral(), 1e-12);
  EXPECT_LE(chi2, 20.0 + 4.0 * std::sqrt(2.0 * 20.0));
}

TEST(DirectionTable, StaysInItsGridAtTheEdges)
{
  // Dark first and last bands and sectors.
  const DirectionTable table({ 0.0, 0.5, 1.0, 1.5, 2.0 }, { 0.0, 1.0, 2.0, 3.0, 4.0 },
    { 0, 0, 0, 0, 0, /**/ 0, 0, 0, 0, 0, /**/ 0, 0, 7, 0, 0, /**/ 0, 0, 0, 0, 0, /**/ 0, 0, 0, 0,
      0 });
  for (const double u : { 0.0, 0x1p-24, 0.5, 1.0 - 0x1p-24, 1.0 - 0x1p-53 })
  {
    for (const double v : { 0.0, 0x1p-24, 0.5, 1.0 - 0x1p-24, 1.0 - 0x1p-53 })
    {
      const glm::dvec2 angles = table.Sample(u, v);
      EXPECT_TRUE(angles.x >= 0.5 && angles.x <= 1.5) << angles.x;
      EXPECT_TRUE(angles.y >= 1.0 && angles.y <= 3.0) << angles.y;
    }
  }
  EXPECT_NEAR(table.Sample(0.5, 0.5).y, 2.0, 1e-9);
}

TEST(FluxTable, NeverChoosesWhatHasNoFlux)
{
  const FluxTable table({ 0.0, 1.0, 0.0, 0.0, 3.0, 1e-300, 0.0 });
  for (const double place : { 0.0, 0x1p-53, 0.25 - 0x1p-54, 0.25, 0.5, 1.0 - 0x1p-53 })
  {
    const std::size_t chosen = table.At(place);
    EXPECT_EQ(chosen, place < 0.25 ? 1u : 4u) << place;
    EXPECT_TRUE(place >= table.Begin(chosen) && place < table.End(chosen));
  }
  RandomNumbers random(4);
  for (const std::size_t many : { 1u, 2u, 3u, 5u, 1000u, 1023u })
  {
    std::vector<double> fluxes;
    for (std::size_t i = 0; i < many; ++i)
    {
      fluxes.push_back(i % 2 == 0 ? 1.0 + random.Unit() : 0.0);
    }
    const FluxTable chooser(fluxes);
    for (int i = 0; i < 10'000; ++i)
    {
      const double place = i == 0 ? 1.0 - 0x1p-53 : random.Bits() * 0x1p-32;
      const std::size_t chosen = chooser.At(place);
      ASSERT_GT(fluxes[chosen], 0.0);
      ASSERT_TRUE(place >= chooser.Begin(chosen) && place < chooser.End(chosen));
    }
  }
}
