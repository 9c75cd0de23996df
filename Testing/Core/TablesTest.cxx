// SPDX-License-Identifier: BSD-3-Clause
// Choices by tables: of directions, among many, and of intervals.
#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/FluxTable.h"
#include "PhotonTransport/lights/IntervalSearch.h"

#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace PhotonTransport;

namespace
{

/// Every interval of a rising list in two.
std::vector<double> Halved(const std::vector<double>& list)
{
  std::vector<double> halves;
  for (std::size_t i = 0; i + 1 < list.size(); ++i)
  {
    halves.push_back(list[i]);
    halves.push_back(0.5 * (list[i] + list[i + 1]));
  }
  halves.push_back(list.back());
  return halves;
}

} // namespace

// Cell by cell of a table of random values, some 0, by Pearson's chi^2; quarters of cells, as the
// density within a cell is not even.
TEST(DirectionTable, SamplesItsDensity)
{
  constexpr int Draws = 400'000;
  RandomNumbers random(2);
  const std::vector<double> polar{ 0.1, 0.3, 0.9, 1.2, 2.0, 3.0 };
  const std::vector<double> azimuth{ -0.5, 0.0, 1.0, 1.5, 4.0 };
  std::vector<double> values;
  for (std::size_t i = 0; i < polar.size() * azimuth.size(); ++i)
  {
    values.push_back(i % 4 == 1 ? 0.0 : random.Unit());
  }
  const DirectionTable table(polar, azimuth, values);
  // The same bilinear function on half the grid's steps.
  const std::vector<double> p = Halved(polar), z = Halved(azimuth);
  const auto value = [&](std::size_t i, std::size_t j) // at z[i], p[j]
  {
    const auto at = [&](std::size_t a, std::size_t b) { return values[a * polar.size() + b]; };
    const std::size_t a = i / 2, b = j / 2, c = a + i % 2, d = b + j % 2;
    return 0.25 * (at(a, b) + at(a, d) + at(c, b) + at(c, d));
  };
  const std::size_t bands = p.size() - 1, sectors = z.size() - 1;
  std::vector<int> counts(bands * sectors, 0);
  for (int draw = 0; draw < Draws; ++draw)
  {
    const double u = random.Unit();
    const glm::dvec2 angles = table.Sample(u, random.Unit());
    ASSERT_TRUE(angles.x >= p.front() && angles.x <= p.back());
    ASSERT_TRUE(angles.y >= z.front() && angles.y <= z.back());
    const auto band = std::upper_bound(p.begin() + 1, p.end() - 1, angles.x) - p.begin() - 1;
    const auto sector = std::upper_bound(z.begin() + 1, z.end() - 1, angles.y) - z.begin() - 1;
    ++counts[static_cast<std::size_t>(sector) * bands + static_cast<std::size_t>(band)];
  }
  double chi2 = 0.0, sum = 0.0;
  int used = 0;
  for (std::size_t i = 0; i < sectors; ++i)
  {
    for (std::size_t j = 0; j < bands; ++j)
    {
      const double integral = DirectionTable({ p[j], p[j + 1] }, { z[i], z[i + 1] },
        { value(i, j), value(i, j + 1), value(i + 1, j), value(i + 1, j + 1) })
                                .Integral();
      const double mean = Draws * integral / table.Integral();
      sum += integral;
      chi2 += mean >= 10.0 ? std::pow(counts[i * bands + j] - mean, 2) / mean : 0.0;
      used += mean >= 10.0;
    }
  }
  EXPECT_NEAR(sum, table.Integral(), 1e-12);
  EXPECT_GT(used, 60);
  EXPECT_LE(chi2, used + 4.0 * std::sqrt(2.0 * used));
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

// The same interval as a search by halves finds, at the edges and beyond them, too.
TEST(IntervalSearch, FindsTheIntervalsOfUnevenLists)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (const std::size_t intervals : { 1u, 2u, 7u, 90u })
  {
    std::vector<double> edges{ -0.3 };
    for (std::size_t i = 0; i < intervals; ++i)
    {
      edges.push_back(edges.back() + 0.001 + std::pow(number(random), 4.0));
    }
    std::vector<double> values = edges;
    values.insert(values.end(), { edges.front() - 1.0, edges.back() + 1.0 });
    for (int i = 0; i < 1000; ++i)
    {
      values.push_back(edges.front() + (edges.back() - edges.front()) * number(random));
    }
    const IntervalSearch search(edges);
    for (const double value : values)
    {
      const auto end = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
      EXPECT_EQ(search.EndOf(value), static_cast<std::size_t>(end - edges.begin())) << value;
    }
  }
}
