// SPDX-License-Identifier: BSD-3-Clause
// Is the error of facet size true? Photon tracing's mean over the facets around a vertex against
// the light at the vertex itself, by the second pass.
#include "Comparison.h"
#include "FacetScenes.h"
#include "Shapes.h"

#include "PhotonTransport/statistics/FacetError.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

/// Vertices of which the error is compared by its root mean square.
enum Group
{
  Borders, ///< Of meshes of flat facets: edges and corners of rooms and boxes.
  Midst,   ///< Elsewhere on flat facets.
  Tilted,  ///< On facets that vertex normals smooth.
  GroupCount
};
constexpr const char* NamesOfGroups[] = { "borders", "midst", "tilted" };

std::vector<Group> GroupsOf(const Scene& scene)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Facet& facet : scene.Facets())
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      ++edges[std::minmax({ facet.vertices[corner], facet.vertices[(corner + 1) % 3] })];
    }
  }
  std::vector<Group> groups;
  for (const Vertex& vertex : scene.Vertices())
  {
    groups.push_back(vertex.IsFlat() ? Midst : Tilted);
  }
  for (const auto& [ends, facets] : edges)
  {
    for (const std::uint32_t end : { ends.first, ends.second })
    {
      groups[end] = facets == 1 && groups[end] == Midst ? Borders : groups[end];
    }
  }
  return groups;
}

struct Light
{
  std::vector<double> illuminance, standardError, facetError;
};

Light Trace(const Scene& scene, const Lighting& lighting, const TraceSettings& settings,
  std::uint64_t photons)
{
  IlluminationRun run(scene, lighting, settings);
  StopRules rules;
  rules.photons = photons;
  run.Advance(rules);
  const IlluminationMap map = run.Front();
  Light light{ map.direct, map.standardError, run.FacetErrorOf(map) };
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    light.illuminance[v] += map.indirect[v];
  }
  return light;
}

double MeanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double Square(double x)
{
  return x * x;
}

/// A mean of squares over a group.
class MeanSquare
{
public:
  /// @param noise The variance of the value, which is not wanted in the mean.
  void Add(double value, double noise = 0.0)
  {
    const double square = Square(value) - noise;
    this->Sum += square;
    // The variance of the square of a normal variable is 2 noise^2 + 4 noise mean^2.
    this->Variances += 2.0 * Square(noise) + 4.0 * noise * std::max(0.0, square);
    this->Count += 1.0;
  }
  bool IsEmpty() const { return this->Count == 0.0; }
  double Root() const { return std::sqrt(std::max(0.0, this->Sum / this->Count)); }
  /// Whether noise alone would hardly give so much.
  bool IsKnown() const { return this->Sum > 4.0 * std::sqrt(this->Variances); }

private:
  double Sum = 0.0, Variances = 0.0, Count = 0.0;
};

class FacetErrorOfScene : public testing::TestWithParam<FacetScene>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Validation, FacetErrorOfScene, testing::ValuesIn(FacetScenes()),
  [](const auto& instance) { return instance.param.name; });

/// Within a factor of two wherever it exceeds the noise, and no more than the noise elsewhere.
TEST_P(FacetErrorOfScene, IsWithinAFactorOfTwo)
{
  const FacetScene& what = GetParam();
  const Scene scene(what.surface);
  TraceSettings settings;
  settings.method = Method::FinalGathering;
  settings.gatherRays = what.rays;
  settings.seed = 2;
  const Light truth = Trace(scene, what.lighting, settings, 500'000);
  settings.method = Method::PhotonTracing;
  settings.gatherRays = 0;
  const Light sharp = Trace(scene, what.lighting, settings, 3 * what.photons);
  const double percent = 100.0 / MeanOf(truth.illuminance);
  const std::vector<Group> groups = GroupsOf(scene);
  int compared = 0;
  for (const std::uint64_t photons : { what.photons, what.photons / 10 })
  {
    settings.seed = 3;
    const Light map = Trace(scene, what.lighting, settings, photons);
    MeanSquare actual[GroupCount], told[GroupCount], noise[GroupCount];
    for (std::size_t v = 0; v < groups.size(); ++v)
    {
      const double unknown = Square(truth.standardError[v]) + Square(sharp.standardError[v]);
      actual[groups[v]].Add(sharp.illuminance[v] - truth.illuminance[v], unknown);
      told[groups[v]].Add(map.facetError[v]);
      noise[groups[v]].Add(map.standardError[v]);
    }
    for (int g = 0; g < GroupCount; ++g)
    {
      if (actual[g].IsEmpty())
      {
        continue;
      }
      const double error = actual[g].Root();
      std::printf("| %s, %s | %.2f%s | %.2f | %.2f |\n", what.name.c_str(), NamesOfGroups[g],
        percent * error, actual[g].IsKnown() ? "" : " (uncertain)", percent * noise[g].Root(),
        percent * told[g].Root());
      if (actual[g].IsKnown() && error > noise[g].Root())
      {
        EXPECT_GT(told[g].Root(), 0.5 * error) << NamesOfGroups[g] << ", " << photons;
        EXPECT_LT(told[g].Root(), 2.0 * error) << NamesOfGroups[g] << ", " << photons;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 0);
}

/// As facets get smaller the error falls, and so does what is told. No photon is traced: the map is
/// the mean itself, by quadrature.
TEST(FacetError, FallsWithTheSizeOfFacets)
{
  const glm::dvec3 lamp(0.2, 0.1, 0.6);
  const auto illuminance = [&](const glm::dvec3& point, const glm::dvec3& normal)
  {
    const glm::dvec3 ray = lamp - point;
    const double d = glm::length(ray);
    return 1000.0 * glm::dot(ray, normal) / (d * d * d);
  };
  double lastActual[GroupCount] = {}, lastTold[GroupCount] = {};
  for (const int cells : { 8, 16, 32 })
  {
    const Surface floor = Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, cells);
    const Scene scene(floor);
    const std::vector<double> map = RingMeans(floor, illuminance);
    const std::vector<double> error =
      FacetError(scene, map, std::vector<double>(map.size(), 0.0), true);
    const std::vector<Group> groups = GroupsOf(scene);
    MeanSquare actual[GroupCount], told[GroupCount];
    for (std::size_t v = 0; v < map.size(); ++v)
    {
      actual[groups[v]].Add(map[v] - illuminance(floor.points[v], floor.normals[v]));
      told[groups[v]].Add(error[v]);
    }
    for (const Group g : { Borders, Midst })
    {
      std::printf("  %d cells, %s: %.2f lx, told %.2f lx\n", cells, NamesOfGroups[g],
        actual[g].Root(), told[g].Root());
      EXPECT_GT(told[g].Root(), 0.5 * actual[g].Root());
      EXPECT_LT(told[g].Root(), 2.0 * actual[g].Root());
      if (cells > 8)
      {
        const double fall = lastActual[g] / actual[g].Root();
        EXPECT_GT(fall, 1.5);
        EXPECT_NEAR(lastTold[g] / told[g].Root() / fall, 1.0, 0.25);
      }
      lastActual[g] = actual[g].Root();
      lastTold[g] = told[g].Root();
    }
  }
}

/// Vertex Normalised is exact on a sphere in parallel light, however coarse, and almost nothing may
/// be told. Flat is not, and its error is told.
TEST(FacetError, KnowsWhatRegistrationCompensates)
{
  const glm::dvec3 towards = glm::normalize(glm::dvec3(-0.3, -0.2, 1.0));
  const auto illuminance = [&](const glm::dvec3&, const glm::dvec3& normal)
  { return 1000.0 * std::max(0.0, glm::dot(towards, normal)); };
  for (const int levels : { 2, 3 })
  {
    const Surface sphere = Shapes::Icosphere(levels, Facing::Outward);
    const Scene scene(sphere);
    std::vector<double> exact;
    for (const glm::dvec3& normal : sphere.normals)
    {
      exact.push_back(illuminance(normal, normal));
    }
    const std::vector<double> means = RingMeans(sphere, illuminance);
    const std::vector<double> noise(exact.size(), 0.0);
    const std::vector<double> compensated = FacetError(scene, exact, noise, true);
    const std::vector<double> flat = FacetError(scene, means, noise, false);
    MeanSquare none, actual, told;
    for (std::size_t v = 0; v < exact.size(); ++v)
    {
      none.Add(compensated[v]);
      actual.Add(means[v] - exact[v]);
      told.Add(flat[v]);
    }
    std::printf("  compensated: told %.2f lx; flat: %.2f lx, told %.2f lx\n", none.Root(),
      actual.Root(), told.Root());
    EXPECT_LT(none.Root(), 0.01 * MeanOf(exact));
    EXPECT_GT(told.Root(), 0.5 * actual.Root());
    EXPECT_LT(told.Root(), 2.0 * actual.Root());
  }
}
