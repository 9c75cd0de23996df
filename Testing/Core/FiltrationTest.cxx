// SPDX-License-Identifier: BSD-3-Clause
// What filtration promises of any map: flux, sign, borders, bits; and maps that are out of the way.
#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/filtration/DarkRegions.h"
#include "PhotonTransport/filtration/PhotonNoise.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"

#include "PhotonMap.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace PhotonTransport;

namespace
{

const FiltrationMonitor NoMonitor = [](double) {};
constexpr double CreaseAngle = 0.7;

SmoothingGraph GraphOf(const Shapes::Surface& surface)
{
  return SmoothingGraph(surface.points, surface.facets, CreaseAngle);
}

/// A map with noise of a standard error, and its groups.
NoisyMap WithNoise(const std::vector<double>& truth, double standardError)
{
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, standardError * std::sqrt(double{ Groups }));
  NoisyMap map{ "map", {}, {}, {} };
  for (const double value : truth)
  {
    GroupValues groups;
    double mean = 0.0;
    for (double& group : groups)
    {
      group = std::max(0.0, value + noise(random));
      mean += group / double{ Groups };
    }
    map.groups.push_back(groups);
    map.values.push_back(mean);
  }
  return map;
}

FilteredMap Smoothed(
  const SmoothingGraph& graph, const NoisyMap& map, const FiltrationSettings& settings = {})
{
  return Filtrate(graph, { map }, {}, settings, NoMonitor).front();
}

std::vector<double> FluxOfPatches(const SmoothingGraph& graph, const std::vector<double>& map)
{
  std::vector<double> flux(graph.Patches(), 0.0);
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    flux[graph.PatchOfVertex()[v]] += graph.VertexAreas()[v] * map[v];
  }
  return flux;
}

void ExpectSoundMap(const SmoothingGraph& graph, const NoisyMap& before, const FilteredMap& after)
{
  for (std::size_t v = 0; v < after.values.size(); ++v)
  {
    ASSERT_TRUE(after.values[v] >= 0.0 && std::isfinite(after.values[v])) << v;
    ASSERT_TRUE(after.squaredError[v] >= 0.0 && std::isfinite(after.squaredError[v])) << v;
  }
  const std::vector<double> had = FluxOfPatches(graph, before.values);
  const std::vector<double> has = FluxOfPatches(graph, after.values);
  for (std::size_t patch = 0; patch < had.size(); ++patch)
  {
    // Sums of n values, each rounded to 2^-53 of the total.
    EXPECT_NEAR(has[patch], had[patch], 1e-12 * had[patch]) << "patch " << patch;
  }
}

Shapes::Surface Square(int cells)
{
  return Shapes::Rectangle(
    glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), cells);
}

/// A map over the square that changes slowly.
std::vector<double> Slope(const Shapes::Surface& surface)
{
  std::vector<double> values;
  for (const glm::dvec3& point : surface.points)
  {
    values.push_back(100.0 + 50.0 * point.x);
  }
  return values;
}

} // namespace

TEST(Filtration, KnowsTheNoiseOfPhotons)
{
  const Shapes::Surface surface = Square(40);
  const SmoothingGraph graph = GraphOf(surface);
  const auto slope = [](const glm::dvec3& place) { return 0.2 + 0.6 * place.x; };
  const PhotonMap traced(surface, slope, 40'000, 1);
  // A photon brings one lumen, exactly so by the count of hits.
  EXPECT_NEAR(LumensPerPhoton(graph, traced.map.values, traced.hits).front(), 1.0, 1e-12);
  GroupColumns columns(traced.hits.size());
  for (std::size_t v = 0; v < columns.size(); ++v)
  {
    for (std::size_t g = 0; g < Groups; ++g)
    {
      columns[v][g] = static_cast<float>(traced.map.groups[v][g]);
    }
  }
  // Of 1681 variances with three degrees of freedom, a third independent: 5 standard errors.
  EXPECT_NEAR(
    LumensPerPhoton(graph, columns).front(), 1.0, 5.0 * std::sqrt(2.0 / 3.0 / (1681.0 / 3.0)));
  const PhotonNoise noise(graph, { 1.0 });
  EXPECT_FLOAT_EQ(static_cast<float>(noise.OnePhoton(840)), 1600.0f) << "a vertex amid squares";
}

TEST(Filtration, LeavesADimRowItsOwnLight)
{
  // A crease's row with a thirtieth of the light beside it, in a map of few photons: the widths
  // that suit the bright vertices would bring it many times its own light.
  constexpr int Cells = 40;
  const Shapes::Surface surface = Square(Cells);
  const SmoothingGraph graph = GraphOf(surface);
  const auto light = [](const glm::dvec3& place)
  {
    const double distance = std::fabs(place.x - 0.5) * Cells;
    return distance < 1.0 ? 0.01 : std::min(1.0, 0.15 * distance);
  };
  const PhotonMap truth(surface, light, 8'000'000, 99);
  constexpr double PhotonsOfTruth = 8e6;
  // How many times the row's squared error may be after smoothing. The widths that are best for the
  // mean square error alone make it 16, 23 and 34 times; where single photons make up a row, as in
  // the first map, it can only be told within some of them.
  struct Case
  {
    int photons;
    double most;
  };
  for (const auto [photons, most] :
    { Case{ 20'000, 8.0 }, Case{ 100'000, 4.0 }, Case{ 500'000, 1.1 } })
  {
    double before = 0.0;
    double after = 0.0;
    double told = 0.0;
    for (const unsigned seed : { 1u, 2u, 3u, 4u })
    {
      const PhotonMap traced(surface, light, photons, seed);
      const FilteredMap smooth =
        Filtrate(graph, { traced.map }, traced.hits, {}, NoMonitor).front();
      for (std::size_t v = 0; v < traced.hits.size(); ++v)
      {
        if (std::fabs(surface.points[v].x - 0.5) < 0.1 / Cells)
        {
          const double expected = truth.map.values[v] * photons / PhotonsOfTruth;
          before += std::pow(traced.map.values[v] - expected, 2);
          after += std::pow(smooth.values[v] - expected, 2);
          told += smooth.squaredError[v];
        }
      }
    }
    EXPECT_LT(after, most * before) << photons;
    EXPECT_GT(std::sqrt(told / after), 0.6) << photons;
    EXPECT_LT(std::sqrt(told / after), 2.0) << photons;
  }
}

TEST(Filtration, KeepsFluxAndSignAndTakesNoise)
{
  const Shapes::Surface surface = Square(60);
  const SmoothingGraph graph = GraphOf(surface);
  const std::vector<double> truth = Slope(surface);
  const NoisyMap noisy = WithNoise(truth, 10.0);
  const FilteredMap smooth = Smoothed(graph, noisy);
  ExpectSoundMap(graph, noisy, smooth);
  double before = 0.0;
  double after = 0.0;
  for (std::size_t v = 0; v < truth.size(); ++v)
  {
    before += std::pow(noisy.values[v] - truth[v], 2);
    after += std::pow(smooth.values[v] - truth[v], 2);
  }
  // The widest kernel means over 4 pi 64 distances squared, some hundreds of vertices; rims, where
  // half of them are missing, hold it to a fraction of that.
  EXPECT_GT(before / after, 50.0);
}

TEST(Filtration, LeavesMapsWithoutNoiseAsTheyAre)
{
  const Shapes::Surface surface = Square(30);
  const SmoothingGraph graph = GraphOf(surface);
  for (const std::vector<double>& truth :
    { Slope(surface), std::vector<double>(surface.points.size(), 7.0),
      std::vector<double>(surface.points.size(), 0.0) })
  {
    const NoisyMap exact = WithNoise(truth, 0.0);
    const FilteredMap smooth = Smoothed(graph, exact);
    for (std::size_t v = 0; v < truth.size(); ++v)
    {
      // Candidates are in single precision, which a mean over the group can't tell from the map.
      EXPECT_NEAR(smooth.values[v], exact.values[v], 1e-5 * exact.values[v]) << v;
    }
  }
}

TEST(Filtration, HasTheSameBitsForAnyNumberOfThreads)
{
  const Shapes::Surface surface = Shapes::Torus(90, 40, Shapes::Facing::Outward);
  const NoisyMap noisy = WithNoise(std::vector<double>(surface.points.size(), 5.0), 1.0);
  std::vector<FilteredMap> results;
  for (const int threads : { 1, 2, 3, 8 })
  {
    Threads(threads).Run([&] { results.push_back(Smoothed(GraphOf(surface), noisy)); });
    EXPECT_EQ(results.back().values, results.front().values) << threads;
    EXPECT_EQ(results.back().squaredError, results.front().squaredError) << threads;
    EXPECT_EQ(results.back().width, results.front().width) << threads;
  }
}

TEST(Filtration, DoesNotDependOnTheUnitOfLength)
{
  Shapes::Surface surface = Square(30);
  const NoisyMap noisy = WithNoise(Slope(surface), 10.0);
  const FilteredMap metres = Smoothed(GraphOf(surface), noisy);
  for (glm::dvec3& point : surface.points)
  {
    point *= 0x1p-40; // areas of 1e-27 are beyond what products of floats hold
  }
  EXPECT_EQ(Smoothed(GraphOf(surface), noisy).values, metres.values);
}

TEST(Filtration, DoesNotCrossCreasesForksAndGaps)
{
  // An L of two squares that share the points of their edge, a third square on the same edge, and
  // one that lies beside them without contact.
  Shapes::Surface surface = Square(10);
  Shapes::Surface wall =
    Shapes::Rectangle(glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), 10);
  surface = Shapes::Together(surface, wall);
  const auto countPatches = [&](const Shapes::Surface& whole)
  {
    const SmoothingGraph graph = GraphOf(whole);
    std::set<std::uint32_t> withEdges;
    for (std::size_t v = 0; v < graph.Vertices(); ++v)
    {
      if (graph.At(v).begin() != graph.At(v).end())
      {
        withEdges.insert(graph.PatchOfVertex()[v]);
      }
    }
    return withEdges.size();
  };
  EXPECT_EQ(countPatches(surface), 2u) << "points of their own: a gap";
  // Weld the wall's points at x = z = 0 to the floor's.
  for (glm::uvec3& facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      for (unsigned p = 0; p < 121; ++p)
      {
        if (surface.points[p] == surface.points[facet[corner]])
        {
          facet[corner] = p;
          break;
        }
      }
    }
  }
  EXPECT_EQ(countPatches(surface), 3u) << "floor, wall, and the crease between";
}

TEST(Filtration, DoesNotCrossAPointWhereSurfacesTouch)
{
  Shapes::Surface surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  surface.facets = { { 0, 1, 2 }, { 0, 3, 4 } };
  const SmoothingGraph graph = GraphOf(surface);
  EXPECT_EQ(graph.Patches(), 3u) << "the point itself, and what is left of each triangle";
}

TEST(Filtration, TakesAnEdgeOfManyFacetsForABorder)
{
  Shapes::Surface surface;
  surface.points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 0.1, 0 }, { -1, -0.1, 0 } };
  surface.facets = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  const SmoothingGraph graph = GraphOf(surface);
  EXPECT_EQ(graph.Patches(), 5u);
}

TEST(Filtration, SpreadsASpikeAMillionTimesTheMean)
{
  const Shapes::Surface surface = Square(40);
  const SmoothingGraph graph = GraphOf(surface);
  NoisyMap map = WithNoise(std::vector<double>(surface.points.size(), 1.0), 0.1);
  map.groups[820] = { 4e6, 0.0, 0.0, 0.0 };
  map.values[820] = 1e6;
  const FilteredMap smooth = Smoothed(graph, map);
  ExpectSoundMap(graph, map, smooth);
  EXPECT_LT(smooth.values[820], 0.1 * map.values[820]);
}

TEST(Filtration, FiltersWhatHasNoNeighbours)
{
  Shapes::Surface surface;
  surface.points = { { 0, 0, 0 } };
  const NoisyMap one{ "map", { 3.0 }, { { 1.0, 5.0, 2.0, 4.0 } }, {} };
  EXPECT_EQ(Smoothed(GraphOf(surface), one).values, one.values);

  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 9, 9, 9 } };
  surface.facets = { { 0, 1, 2 }, { 0, 0, 1 }, { 1, 2, 2 } }; // two of them have no area
  const NoisyMap few = WithNoise({ 1.0, 2.0, 3.0, 4.0 }, 0.5);
  const FilteredMap smooth = Smoothed(GraphOf(surface), few);
  ExpectSoundMap(GraphOf(surface), few, smooth);
  EXPECT_EQ(smooth.values[3], few.values[3]);
}

TEST(Filtration, KeepsTwoPatchesApart)
{
  Shapes::Surface surface = Shapes::Together(
    Square(20), Shapes::Rectangle({ 5.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 20));
  const SmoothingGraph graph = GraphOf(surface);
  std::vector<double> truth(surface.points.size(), 0.0);
  std::fill(truth.begin() + 441, truth.end(), 100.0);
  NoisyMap noisy = WithNoise(truth, 10.0);
  std::fill(noisy.values.begin(), noisy.values.begin() + 441, 0.0);
  std::fill(noisy.groups.begin(), noisy.groups.begin() + 441, GroupValues{});
  const FilteredMap smooth = Smoothed(graph, noisy);
  ExpectSoundMap(graph, noisy, smooth);
  EXPECT_EQ(std::vector<double>(smooth.values.begin(), smooth.values.begin() + 441),
    std::vector<double>(441, 0.0));
}

TEST(Filtration, KeepsCertainlyDarkRegionsDark)
{
  const Shapes::Surface surface = Square(40);
  const SmoothingGraph graph = GraphOf(surface);
  std::vector<double> truth, hits;
  for (const glm::dvec3& point : surface.points)
  {
    truth.push_back(point.x < 0.5 ? 0.0 : 100.0);
    hits.push_back(point.x < 0.5 ? 0.0 : 90.0);
  }
  NoisyMap noisy = WithNoise(truth, 10.0);
  for (std::size_t v = 0; v < truth.size(); ++v)
  {
    if (truth[v] == 0.0)
    {
      noisy.values[v] = 0.0;
      noisy.groups[v] = {};
    }
  }
  for (const FiltrationMethod method : { FiltrationMethod::Adaptive, FiltrationMethod::Diffusion })
  {
    const FilteredMap smooth = Filtrate(graph, { noisy }, hits, { method }, NoMonitor).front();
    for (std::size_t v = 0; v < truth.size(); ++v)
    {
      EXPECT_EQ(smooth.values[v] == 0.0, truth[v] == 0.0) << v;
      EXPECT_GT(smooth.squaredError[v], 0.0) << "a photon may still come to vertex " << v;
    }
  }
  // A single vertex without a photon where there are three is chance, where there are 90 it is not.
  std::vector<double> few(surface.points.size(), 3.0);
  few[800] = 0.0;
  EXPECT_TRUE(FindDarkRegions(graph, few).empty());
  std::vector<double> many(surface.points.size(), 90.0);
  many[800] = 0.0;
  ASSERT_FALSE(FindDarkRegions(graph, many).empty());
  EXPECT_EQ(FindDarkRegions(graph, many)[800], 1);
}

TEST(Filtration, RefusesBadInputByName)
{
  const Shapes::Surface surface = Square(4);
  const SmoothingGraph graph = GraphOf(surface);
  const auto messageOf = [&](const NoisyMap& map, const FiltrationSettings& settings)
  {
    try
    {
      Smoothed(graph, map, settings);
    }
    catch (const InvalidInput& error)
    {
      return std::to_string(error.Index) + ": " + error.what();
    }
    return std::string("accepted");
  };
  NoisyMap map = WithNoise(std::vector<double>(25, 1.0), 0.1);
  EXPECT_EQ(messageOf(map, { FiltrationMethod::Adaptive, -1.0 }),
    "0: the strength is -1.000000; it must be within [0, 10]");
  EXPECT_EQ(messageOf(map, { FiltrationMethod::Diffusion, 1.0, 51.0 }),
    "0: the width is 51.000000; it must be within [0, 50]");
  map.groups[3][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(messageOf(map, {}), "3: a group mean of map is not finite");
  map.values[17] = std::nan("");
  EXPECT_EQ(messageOf(map, {}), "17: map is nan; it must be a finite number >= 0");
  map.values[17] = -1.0;
  EXPECT_EQ(messageOf(map, {}), "17: map is -1.000000; it must be a finite number >= 0");
}

TEST(Filtration, DiffusionKeepsFluxAndConstants)
{
  const Shapes::Surface surface = Shapes::Torus(40, 20, Shapes::Facing::Outward);
  const SmoothingGraph graph = GraphOf(surface);
  const NoisyMap noisy = WithNoise(std::vector<double>(surface.points.size(), 5.0), 1.0);
  const FilteredMap smooth = Smoothed(graph, noisy, { FiltrationMethod::Diffusion, 1.0, 50.0 });
  ExpectSoundMap(graph, noisy, smooth);
  const auto [least, most] = std::minmax_element(smooth.values.begin(), smooth.values.end());
  EXPECT_LT(*most - *least, 0.5) << "50 distances are more than the torus has";
  const NoisyMap none = WithNoise(std::vector<double>(surface.points.size(), 5.0), 1.0);
  EXPECT_EQ(Smoothed(graph, none, { FiltrationMethod::None }).values, none.values);
}
