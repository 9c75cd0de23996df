// SPDX-License-Identifier: BSD-3-Clause
// Filtration of traced maps whose truth is known: what it saves and what it says of its error.
#include "Shapes.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;

namespace
{

/// Mean squares over the area, lx^2.
struct Squares
{
  double before = 0.0;
  double after = 0.0;
  double told = 0.0;
};

/// A sphere in parallel light, max(0, cos) of the brightest, traced with so many photons a vertex.
Squares SphereInParallelLight(double photons, std::uint32_t seed, bool knowsGroups)
{
  const Shapes::Surface surface = Shapes::Octasphere(5, Shapes::Facing::Outward);
  const Scene scene(surface);
  TraceSettings settings;
  settings.seed = seed;
  settings.sampling = Sampling::Random; // Sobol leaves next to no noise here
  IlluminationRun run(scene, ParallelLight{ glm::dvec3(0.0, 0.0, -1.0), 1000.0 }, settings);
  run.Advance({ static_cast<std::uint64_t>(photons * double(surface.points.size())) });

  const IlluminationMap map = run.Front();
  NoisyMap part{ "IlluminanceDirect", map.direct, {}, map.standardError };
  if (knowsGroups)
  {
    part.groups = run.FrontByGroups().direct;
  }
  const SmoothingGraph graph(surface.points, surface.facets, 0.7);
  const std::vector<double> hits(map.photonHits.begin(), map.photonHits.end());
  const FilteredMap smooth = Filtrate(graph, { part }, hits, {}, [](double) {}).front();
  Squares squares;
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    const double truth = 1000.0 * std::max(0.0, surface.normals[v].z);
    squares.before += scene.VertexAreas()[v] * std::pow(map.direct[v] - truth, 2);
    squares.after += scene.VertexAreas()[v] * std::pow(smooth.values[v] - truth, 2);
    squares.told += scene.VertexAreas()[v] * smooth.squaredError[v];
  }
  return squares;
}

} // namespace

TEST(Filtration, SavesPhotonsAndKnowsWhatErrorIsLeft)
{
  for (const double photons : { 5.0, 50.0, 500.0 })
  {
    Squares sum;
    for (const std::uint32_t seed : { 1u, 2u, 3u })
    {
      const Squares one = SphereInParallelLight(photons, seed, true);
      EXPECT_GT(one.before / one.after, 1.0) << photons << " photons, seed " << seed;
      sum.before += one.before;
      sum.after += one.after;
      sum.told += one.told;
    }
    // The narrowest kernel, which every vertex may choose, leaves a third of the noise; a choice
    // that is worth its name does better than that.
    EXPECT_GT(sum.before / sum.after, 3.0) << photons;
    const double ratio = std::sqrt(sum.told / sum.after);
    EXPECT_GT(ratio, 0.7) << photons;
    EXPECT_LT(ratio, 1.6) << photons;
  }
}

TEST(Filtration, SavesPhotonsWithTheStandardErrorAlone)
{
  const Squares squares = SphereInParallelLight(20.0, 4, false);
  EXPECT_GT(squares.before / squares.after, 3.0);
}

TEST(Filtration, GroupsAreTheMap)
{
  const Scene scene(Shapes::WithReflectance(Shapes::RoomWithSphere(2000), 0.5f));
  IlluminationRun run(scene, PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 }, TraceSettings());
  EXPECT_TRUE(run.FrontByGroups().direct.empty()) << "nothing is traced yet";
  run.Advance({ 100'000 });
  const IlluminationMap map = run.Front();
  const GroupMeans groups = run.FrontByGroups();
  double variance = 0.0;
  double told = 0.0;
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    GroupValues total;
    double direct = 0.0;
    double indirect = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      direct += groups.direct[v][g] / double{ Groups };
      indirect += groups.indirect[v][g] / double{ Groups };
      total[g] = groups.direct[v][g] + groups.indirect[v][g];
    }
    EXPECT_NEAR(direct, map.direct[v], 1e-12 * map.direct[v]);
    EXPECT_NEAR(indirect, map.indirect[v], 1e-12 * map.indirect[v]);
    for (const double value : total)
    {
      variance += std::pow(value - direct - indirect, 2) / double{ Groups * (Groups - 1) };
    }
    told += std::pow(map.standardError[v], 2);
  }
  // Both estimate the same variance, from 3 and 7 degrees of freedom a vertex; photons that touch
  // three vertices leave a third of the 2000-odd independent: 3 standard errors of the ratio.
  const double independent = double(map.direct.size()) / 3.0;
  EXPECT_NEAR(variance / told, 1.0, 3.0 * std::sqrt((2.0 / 3.0 + 2.0 / 7.0) / independent) * 3.0);
}
