// SPDX-License-Identifier: BSD-3-Clause
// How many photons filtration saves: (RMS error before / after)^2, since the squared error falls as
// one over the photons.
//
//   FiltrationSavings [scenes [first seed [seeds]]]        for example: FiltrationSavings ABCD 1 10
//
// Errors are against a map of many more photons by a seed of its own, whose noise is subtracted.
// It takes about two minutes a scene for that map and ten seconds a seed.
#include "FiltrationScenes.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr std::array<double, 6> Budgets{ 3, 10, 30, 100, 300, 1000 }; // photon hits a vertex
constexpr double ReferenceHits = 20'000;
constexpr double ReferenceHitsOfSmallMesh = 200'000;
constexpr std::uint32_t ReferenceSeed = 1'000'000;

/// Goes on to so many hits a vertex; the segments of one photon have been seen before.
void Advance(IlluminationRun& run, std::size_t vertices, double hitsPerVertex)
{
  if (run.Balance().emitted == 0)
  {
    run.Advance({ 1 });
  }
  const auto segments = static_cast<double>(run.Balance().segments);
  const double perPhoton = segments / static_cast<double>(run.Balance().emitted);
  const double photons = hitsPerVertex * static_cast<double>(vertices) / perPhoton;
  run.Advance({ std::max<std::uint64_t>(1, static_cast<std::uint64_t>(photons)) });
}

/// The map as good as it gets, and what errors are measured by.
struct Truth
{
  std::vector<double> areas, lux, variance;
  double mean = 0.0;
  std::vector<bool> atEdge; ///< Beside a vertex that is a third darker or brighter.

  Truth(const Scene& scene, const Lamp& lamp, const SmoothingGraph& graph)
    : areas(scene.VertexAreas())
    , atEdge(areas.size(), false)
  {
    TraceSettings settings;
    settings.seed = ReferenceSeed;
    IlluminationRun run(scene, lamp, settings);
    Advance(run, areas.size(), areas.size() < 1000 ? ReferenceHitsOfSmallMesh : ReferenceHits);
    const IlluminationMap map = run.Front();
    double area = 0.0;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
      lux.push_back(map.direct[v] + map.indirect[v]);
      variance.push_back(map.standardError[v] * map.standardError[v]);
      mean += areas[v] * lux[v];
      area += areas[v];
    }
    mean /= area;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
      for (const SmoothingGraph::Edge& edge : graph.At(v))
      {
        const double brighter = std::max(lux[v], lux[edge.neighbour]);
        const double step = std::fabs(lux[v] - lux[edge.neighbour]);
        atEdge[v] = atEdge[v] || (brighter > 0.1 * mean && step > 0.3 * brighter);
      }
    }
  }
};

enum Measure
{
  Absolute,
  Relative, ///< To the truth and 5 % of its mean.
  AtEdges,
  Measures
};

/// Mean squared errors over the area, without the truth's own noise.
std::array<double, Measures> SquaredErrors(const Truth& truth, const std::vector<double>& lux)
{
  std::array<double, Measures> sums{};
  double area = 0.0;
  for (std::size_t v = 0; v < lux.size(); ++v)
  {
    const double difference = lux[v] - truth.lux[v];
    const double square = truth.areas[v] * (difference * difference - truth.variance[v]);
    const double scale = truth.lux[v] + 0.05 * truth.mean;
    sums[Absolute] += square;
    sums[Relative] += square / (scale * scale);
    sums[AtEdges] += truth.atEdge[v] ? square : 0.0;
    area += truth.areas[v];
  }
  for (double& sum : sums)
  {
    sum /= area;
  }
  return sums;
}

/// Ways to smooth a map that are compared.
enum Way
{
  Ours,
  ByStandardError,
  ByMapAlone,
  Diffusion,
  Ways
};
constexpr std::array<const char*, Ways> NameOfWay{ "Adaptive, with group means",
  "Adaptive, with the standard error alone", "Adaptive, with the map alone",
  "Diffusion, width 2, as plain smoothing does" };

struct Smoothed
{
  std::vector<double> lux;
  double toldSquare = 0.0; ///< Mean over the area.
};

Smoothed Smooth(
  const SmoothingGraph& graph, const IlluminationRun& run, const Truth& truth, Way way)
{
  const IlluminationMap map = run.Front();
  std::vector<NoisyMap> parts;
  if (way == Ours)
  {
    const GroupMeans groups = run.FrontByGroups();
    parts = { { "direct", map.direct, groups.direct, {} },
      { "indirect", map.indirect, groups.indirect, {} } };
  }
  else
  {
    NoisyMap whole{ "map", map.direct, {}, {} };
    for (std::size_t v = 0; v < map.indirect.size(); ++v)
    {
      whole.values[v] += map.indirect[v];
    }
    whole.standardError = way == ByMapAlone ? std::vector<double>() : map.standardError;
    parts = { whole };
  }
  FiltrationSettings settings;
  settings.method = way == Diffusion ? FiltrationMethod::Diffusion : FiltrationMethod::Adaptive;
  settings.width = 2.0;
  std::vector<double> hits(map.photonHits.begin(), map.photonHits.end());
  if (way == ByMapAlone)
  {
    hits.clear();
  }
  Smoothed smoothed{ std::vector<double>(map.direct.size(), 0.0) };
  double area = 0.0;
  for (const FilteredMap& part : Filtrate(graph, parts, hits, settings, [](double) {}))
  {
    area = 0.0;
    for (std::size_t v = 0; v < smoothed.lux.size(); ++v)
    {
      smoothed.lux[v] += part.values[v];
      smoothed.toldSquare += truth.areas[v] * part.squaredError[v];
      area += truth.areas[v];
    }
  }
  smoothed.toldSquare /= area;
  return smoothed;
}

/// What one way has done with the maps of one budget, seed by seed.
struct Results
{
  std::array<double, Measures> logSaving{};
  double leastSaving = 1e300;
  double errorBefore = 0.0, errorAfter = 0.0; // % of the mean
  double toldOverTrue = 0.0;
  double leastTold = 1e300, mostTold = 0.0;
  int seeds = 0;

  void Add(const Truth& truth, const std::array<double, Measures>& before,
    const std::array<double, Measures>& after, double toldSquare)
  {
    for (std::size_t m = 0; m < Measures; ++m)
    {
      logSaving[m] += std::log(before[m] / after[m]);
    }
    leastSaving = std::min(leastSaving, before[Absolute] / after[Absolute]);
    errorBefore += 100.0 * std::sqrt(before[Absolute]) / truth.mean;
    errorAfter += 100.0 * std::sqrt(after[Absolute]) / truth.mean;
    const double told = std::sqrt(toldSquare / after[Absolute]);
    toldOverTrue += told;
    leastTold = std::min(leastTold, told);
    mostTold = std::max(mostTold, told);
    ++seeds;
  }
  double Saving(Measure measure) const { return std::exp(logSaving[measure] / seeds); }
};

void Print(double budget, Way way, const Results& r)
{
  std::printf("| %g | %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f (%.2f to %.2f) |\n",
    budget, NameOfWay[way], r.Saving(Absolute), r.leastSaving, r.Saving(Relative),
    r.Saving(AtEdges), r.errorBefore / r.seeds, r.errorAfter / r.seeds, r.toldOverTrue / r.seeds,
    r.leastTold, r.mostTold);
  std::fflush(stdout);
}

void Measure(const FiltrationScene& what, std::uint32_t firstSeed, int seeds)
{
  const Scene scene(what.surface);
  constexpr double CreaseAngle = 40.0 * 3.14159265358979323846 / 180.0;
  const SmoothingGraph graph(what.surface.points, what.surface.facets, CreaseAngle);
  const Truth truth(scene, what.lamp, graph);
  std::array<std::array<Results, Ways>, Budgets.size()> results;
  for (int s = 0; s < seeds; ++s)
  {
    TraceSettings settings;
    settings.seed = firstSeed + static_cast<std::uint32_t>(s);
    IlluminationRun run(scene, what.lamp, settings);
    for (std::size_t b = 0; b < Budgets.size(); ++b)
    {
      Advance(run, graph.Vertices(), Budgets[b]);
      const IlluminationMap map = run.Front();
      std::vector<double> raw(map.direct);
      std::transform(raw.begin(), raw.end(), map.indirect.begin(), raw.begin(), std::plus<>());
      const auto before = SquaredErrors(truth, raw);
      for (std::size_t way = 0; way < Ways; ++way)
      {
        const Smoothed smoothed = Smooth(graph, run, truth, static_cast<Way>(way));
        results[b][way].Add(truth, before, SquaredErrors(truth, smoothed.lux), smoothed.toldSquare);
      }
    }
  }
  std::printf(
    "\nScene %s, %s: %zu vertices, seeds %u to %u\n\n"
    "| hits a vertex | smoothing | saving | least of the seeds | relative error | at edges | "
    "error before, %% | after, %% | told over true error |\n"
    "|---|---|---|---|---|---|---|---|---|\n",
    what.name.c_str(), what.what.c_str(), graph.Vertices(), firstSeed,
    firstSeed + static_cast<std::uint32_t>(seeds) - 1);
  for (std::size_t way = 0; way < Ways; ++way)
  {
    for (std::size_t b = 0; b < Budgets.size(); ++b)
    {
      Print(Budgets[b], static_cast<Way>(way), results[b][way]);
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string scenes = argc > 1 ? argv[1] : "ABCDE";
  const auto firstSeed = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  const int seeds = argc > 3 ? std::atoi(argv[3]) : 10;
  for (const FiltrationScene& scene : FiltrationScenes())
  {
    if (scenes.find(scene.name) != std::string::npos)
    {
      Measure(scene, firstSeed, seeds);
    }
  }
  return 0;
}
