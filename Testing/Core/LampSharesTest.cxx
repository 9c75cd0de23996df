// SPDX-License-Identifier: BSD-3-Clause
// Lamps of small flux among strong ones: their photons, and the errors of maps whose photons start
// with many weights.
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Scene Room()
{
  return Scene(Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 8, Facing::Inward), 0.5f));
}

/// Lamps of 0.01 to 10^4 lm, spread over the room.
Lighting ManyLamps(int number)
{
  Lighting lighting;
  for (int i = 0; i < number; ++i)
  {
    const double flux = std::pow(10.0, -2.0 + 6.0 * i / (number - 1));
    const auto turn = [&](double angle) { return 0.8 * std::sin(angle * i); };
    lighting.luminaires.push_back({ SpotLamp{ { turn(1.0), turn(2.3), turn(3.7) },
                                      { turn(5.1), turn(0.7), -1.0 }, 0.6, 0.0, flux },
      "", Colour(1.0f) });
  }
  return lighting;
}

TraceSettings Settings(std::uint32_t seed, bool apart = true)
{
  TraceSettings settings;
  settings.lampsApart = apart;
  settings.seed = seed;
  return settings;
}

} // namespace

TEST(LampShares, EveryLampOfManyHasAMap)
{
  constexpr int Number = 200;
  const Scene scene = Room();
  IlluminationRun run(scene, ManyLamps(Number), Settings(1));
  run.Advance({ 1'000'000 });
  const std::vector<Arrivals> arrivals = run.ArrivalsByLamp();
  for (std::size_t l = 0; l < Number; ++l)
  {
    const auto photons = static_cast<double>(arrivals[l].Emitted());
    EXPECT_GE(photons, 0.95 * static_cast<double>(run.Balance().emitted) / 20.0 / Number) << l;
    const IlluminationMap map = run.MapOfLamp(l);
    const double brightest = *std::max_element(map.direct.begin(), map.direct.end());
    EXPECT_GT(brightest, 0.0) << l;
  }
}

// What even shares for small lamps take from the others: less than 1/19 of the variance.
TEST(LampShares, CostTheWholeMapLittle)
{
  const Scene scene = Room();
  const Lighting lighting = ManyLamps(24);
  double squares[2] = {};
  for (std::uint32_t seed = 1; seed <= 12; ++seed)
  {
    for (const bool apart : { false, true })
    {
      IlluminationRun run(scene, lighting, Settings(seed, apart));
      run.Advance({ 400'000 });
      for (const double error : run.Front().standardError)
      {
        squares[apart] += error * error;
      }
    }
  }
  std::printf("  variance with shares over without: %.4f\n", squares[1] / squares[0]);
  // A variance of 8 replicates has a relative error of sqrt(2 / 7); 12 seeds and hundreds of
  // vertices, which share photons: 72 of them count, as many as there are patches of 3 by 3.
  const double spread = std::sqrt(2.0 * 2.0 / 7.0 / (12.0 * 72.0));
  EXPECT_LE(squares[1] / squares[0], 1.0 + 1.0 / 19.0 + 4.0 * spread);
}

// Errors of the whole map and of lamps, against the spread of seeds.
TEST(LampShares, ErrorsAreThoseOfOtherSeeds)
{
  constexpr std::uint32_t Seeds = 40;
  const Scene scene = Room();
  const Lighting lighting = ManyLamps(12);
  const std::size_t vertices = scene.VertexAreas().size();
  for (const std::size_t lamp : { std::size_t{ 12 }, std::size_t{ 2 }, std::size_t{ 11 } })
  {
    std::vector<double> sum(vertices, 0.0);
    std::vector<double> squares(vertices, 0.0);
    double told = 0.0;
    std::vector<IlluminationMap> maps;
    for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
    {
      IlluminationRun run(scene, lighting, Settings(seed));
      run.Advance({ 400'000 });
      maps.push_back(lamp < 12 ? run.MapOfLamp(lamp) : run.Front());
      for (std::size_t v = 0; v < vertices; ++v)
      {
        const double light = maps.back().direct[v] + maps.back().indirect[v];
        sum[v] += light / Seeds;
        squares[v] += light * light / Seeds;
        told += std::pow(maps.back().standardError[v], 2.0) / Seeds;
      }
    }
    double variance = 0.0;
    double covered = 0.0;
    for (std::size_t v = 0; v < vertices; ++v)
    {
      variance += (squares[v] - sum[v] * sum[v]) * Seeds / (Seeds - 1.0);
      for (const IlluminationMap& map : maps)
      {
        const double error = map.direct[v] + map.indirect[v] - sum[v];
        covered += std::fabs(error) <= 3.0 * map.standardError[v];
      }
    }
    covered /= static_cast<double>(vertices * Seeds);
    std::printf("  lamp %d: told over true %.3f, within 3 errors %.2f %%\n", static_cast<int>(lamp),
      std::sqrt(told / variance), 100.0 * covered);
    // Student's t with 7 degrees of freedom; a hit counts at three points.
    const double spread = std::sqrt(0.98 * 0.02 * 3.0 / static_cast<double>(vertices * Seeds));
    EXPECT_GE(covered, 0.98 - 4.0 * spread) << lamp;
    EXPECT_GE(std::sqrt(told / variance), 0.95) << lamp;
    // Of few hits more is told than is true: up to 5 times, see FewHitsTest.
    EXPECT_LE(std::sqrt(told / variance), lamp == 2 ? 5.0 : 1.1) << lamp;
  }
}
