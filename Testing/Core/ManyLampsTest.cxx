// SPDX-License-Identifier: BSD-3-Clause
// Several lamps together, and each one's light apart.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint64_t Photons = 400'000;

TraceSettings RandomSettings()
{
  TraceSettings settings;
  settings.sampling = Sampling::Random;
  return settings;
}

} // namespace

// Photons per lamp follow the fluxes, and each lamp's light is what it gives alone.
TEST(ManyLamps, ShareThePhotonsByFlux)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  Lighting lighting;
  const double fluxes[] = { 0.0, 1.0, 100.0, 0.0, 10.0, 889.0, 0.0 };
  for (const double flux : fluxes)
  {
    lighting.luminaires.push_back({ PointLamp{ {}, flux }, "", Colour(1.0f) });
  }
  for (const Sampling sampling : { Sampling::Random, Sampling::Sobol })
  {
    const Emitter emitter(lighting, scene);
    EXPECT_EQ(emitter.Flux(), 1000.0);
    constexpr int Many = 200'000;
    int counts[7] = {};
    PhotonSequence sample({ 3, 0, sampling }, 0);
    for (int i = 0; i < Many; ++i, sample.Advance())
    {
      ++counts[emitter.Emit(sample).source];
    }
    for (int lamp = 0; lamp < 7; ++lamp)
    {
      const double share = fluxes[lamp] / 1000.0;
      EXPECT_NEAR(counts[lamp], Many * share, 4.0 * std::sqrt(Many * share * (1.0 - share)));
    }
  }
}

TEST(ManyLamps, LayersAreTheLampsOwnAndSumUp)
{
  const Surface room = Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Inward), 0.5f);
  const Scene scene(room);
  const Lamp lamps[] = { SpotLamp{ { 0, 0, 0 }, { 0, 0, -1 }, 0.3, 0.0, 300.0 },
    PointLamp{ { 0.5, 0.5, 0.5 }, 700.0 },
    EmittingMesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 1 } },
      { 100.0f, 900.0f } } };
  Lighting together;
  for (const Lamp& lamp : lamps)
  {
    together.luminaires.push_back({ lamp, "", Colour(1.0f) });
  }
  TraceSettings settings = RandomSettings();
  settings.lampsApart = true;
  IlluminationRun run(scene, together, settings);
  run.Advance({ Photons });
  const IlluminationMap front = run.Front();
  std::vector<double> sums(front.direct.size(), 0.0);
  const double photons = static_cast<double>(run.Balance().emitted);
  for (std::size_t l = 0; l < 3; ++l)
  {
    const std::vector<double> own = run.FrontOfLamp(l);
    TraceSettings many = RandomSettings();
    many.replicates = 64; // so that the standard error is known to a tenth
    const TracedMap alone(scene, lamps[l], many, Photons);
    double chi2 = 0.0;
    for (std::size_t v = 0; v < own.size(); ++v)
    {
      sums[v] += own[v];
      const double expected = alone.front.direct[v] + alone.front.indirect[v];
      // A sum of n weights w of a lamp with a share s of N photons: alone it is s times as noisy in
      // its square, but chance also decides how many photons the lamp gets.
      const double share = Emitter(lamps[l], scene).Flux() / run.Flux();
      const double noise = std::pow(alone.front.standardError[v], 2);
      const double variance =
        noise * (1.0 + 1.0 / share) + expected * expected * (1.0 - share) / (share * photons);
      chi2 += std::pow(own[v] - expected, 2) / variance;
    }
    // Of six walls, whose vertices share photons: a mean of 6 squares of deviation 1.
    EXPECT_LE(chi2 / static_cast<double>(own.size()), 1.0 + 4.0 * std::sqrt(2.0 / 6.0)) << l;
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    const double whole = front.direct[v] + front.indirect[v];
    EXPECT_NEAR(sums[v], whole, 16.0 * 0x1p-53 * whole); // integers, then a few roundings
  }
}
