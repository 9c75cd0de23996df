// SPDX-License-Identifier: BSD-3-Clause
// Does the error bar hold where few photons came? Many seeds of scenes with a known answer, at
// numbers of photons that double, so that points of every dimness are as frequent: how many points
// with so many hits lie within 3 standard errors. With 8 replicates that is Student's t with 7
// degrees of freedom, 98.0 %.
#include "Comparison.h"
#include "Shapes.h"
#include "TracedMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

struct DimScene
{
  std::string name;
  Surface surface;
  Lamp lamp;
  std::vector<double> expected; ///< [vertex], lx
};

std::ostream& operator<<(std::ostream& os, const DimScene& scene)
{
  return os << scene.name;
}

/// Walls that shine and reflect: E = M / (1 - rho) everywhere.
DimScene Furnace()
{
  const Surface box = Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 48, Facing::Inward);
  return { "Furnace", Shapes::WithExitance(Shapes::WithReflectance(box, 0.5f), 100.0f),
    EmittingFacets{}, std::vector<double>(box.points.size(), 200.0) };
}

/// A lamp low above a floor, a hundred times brighter below it than in the corners.
DimScene Floor()
{
  const Surface floor = Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 60);
  const glm::dvec3 lamp(0.2, 0.1, 0.3);
  const auto illuminance = [=](const glm::dvec3& point, const glm::dvec3& normal)
  {
    const glm::dvec3 ray = point - lamp;
    const double d = glm::length(ray);
    return 1000.0 / (4.0 * 3.14159265358979) * -glm::dot(ray, normal) / (d * d * d);
  };
  return { "Floor", floor, PointLamp{ lamp, 1000.0 }, RingMeans(floor, illuminance) };
}

/// From full light to none, by compensated registration, which is exact here; half is dark.
DimScene Sphere()
{
  const ParallelLight light{ { 0.3, 0.2, -1.0 }, 1000.0 };
  DimScene scene{ "Sphere", Shapes::Icosphere(4, Facing::Outward), light, {} };
  for (const glm::dvec3& normal : scene.surface.normals)
  {
    scene.expected.push_back(
      1000.0 * std::max(0.0, -glm::dot(glm::normalize(light.direction), normal)));
  }
  return scene;
}

struct HitClass
{
  std::uint64_t least;
  const char* name;
};
constexpr std::array<HitClass, 6> Classes{ { { 0, "0" }, { 1, "1" }, { 2, "2" }, { 3, "3-9" },
  { 10, "10-29" }, { 30, "30+" } } };

struct Tally
{
  double points = 0.0;
  double inside = 0.0;
  double squaredError = 0.0;
  double squaredClaim = 0.0;
};

std::size_t ClassOf(std::uint64_t hits)
{
  std::size_t place = Classes.size() - 1;
  while (Classes[place].least > hits)
  {
    --place;
  }
  return place;
}

void Add(std::array<Tally, Classes.size()>& tallies, const IlluminationMap& map,
  const std::vector<double>& expected)
{
  for (std::size_t v = 0; v < expected.size(); ++v)
  {
    if (expected[v] > 0.0) // what is dark lies within any bound
    {
      Tally& tally = tallies[ClassOf(map.photonHits[v])];
      const double error = map.direct[v] + map.indirect[v] - expected[v];
      tally.points += 1.0;
      tally.inside += std::fabs(error) <= 3.0 * map.standardError[v];
      tally.squaredError += error * error;
      tally.squaredClaim += map.standardError[v] * map.standardError[v];
    }
  }
}

class FewHitsCoverage : public testing::TestWithParam<std::tuple<DimScene, Sampling>>
{
};

std::string NameOf(const testing::TestParamInfo<std::tuple<DimScene, Sampling>>& instance)
{
  return std::get<0>(instance.param).name +
    (std::get<1>(instance.param) == Sampling::Sobol ? "Sobol" : "Random");
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Validation, FewHitsCoverage,
  testing::Combine(testing::Values(Furnace(), Floor(), Sphere()),
    testing::Values(Sampling::Random, Sampling::Sobol)),
  NameOf);

TEST_P(FewHitsCoverage, IsWhatReplicatesPromise)
{
  constexpr int Seeds = 8;
  constexpr double Promised = 0.98;
  const auto& [scene, sampling] = GetParam();
  const Scene prepared(scene.surface);
  std::array<Tally, Classes.size()> tallies{};
  for (std::uint64_t photons = 2048; photons <= 65'536; photons *= 2)
  {
    for (int seed = 1; seed <= Seeds; ++seed)
    {
      TraceSettings settings;
      settings.sampling = sampling;
      settings.seed = static_cast<std::uint32_t>(seed);
      Add(tallies, TracedMap(prepared, scene.lamp, settings, photons).front, scene.expected);
    }
  }
  std::printf("  | hits | points | within 3 standard errors, %% | claimed over true error |\n");
  for (std::size_t c = 0; c < Classes.size(); ++c)
  {
    const Tally& tally = tallies[c];
    const double coverage = tally.inside / tally.points;
    const double claim = std::sqrt(tally.squaredClaim / tally.squaredError);
    std::printf(
      "  | %s | %.0f | %.2f | %.2f |\n", Classes[c].name, tally.points, 100.0 * coverage, claim);
    // A hit counts at three points, so their errors are not independent.
    const double spread = std::sqrt(Promised * (1.0 - Promised) * 3.0 / tally.points);
    EXPECT_GE(coverage, Promised - 4.0 * spread) << Classes[c].name;
    // No wider than honesty needs: where there are many hits, as replicates say.
    EXPECT_GE(claim, Classes[c].least >= 10 ? 0.9 : 1.0) << Classes[c].name;
    EXPECT_LE(claim, Classes[c].least >= 30 ? 1.1 : 5.0) << Classes[c].name;
  }
}
