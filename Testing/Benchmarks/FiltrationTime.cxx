// SPDX-License-Identifier: BSD-3-Clause
// Seconds and memory of filtration against the number of vertices.
//
//   FiltrationTime [threads [vertices...]]      for example: FiltrationTime 2 10000 1000000
//
// The mesh is a square of that many vertices, numbered row by row, and then at random, as a mesh
// may come. Memory is the process's peak so far, the input and the mesh included.
#include "Measurement.h"
#include "Shapes.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/threads/Threads.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

using namespace PhotonTransport;

namespace
{

Shapes::Surface Shuffled(const Shapes::Surface& surface)
{
  std::mt19937 random(1);
  std::vector<unsigned> number(surface.points.size());
  std::iota(number.begin(), number.end(), 0u);
  std::shuffle(number.begin(), number.end(), random);
  Shapes::Surface shuffled = surface;
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    shuffled.points[number[p]] = surface.points[p];
  }
  for (glm::uvec3& facet : shuffled.facets)
  {
    facet = { number[facet.x], number[facet.y], number[facet.z] };
  }
  std::shuffle(shuffled.facets.begin(), shuffled.facets.end(), random);
  return shuffled;
}

/// A slope with noise that four groups know.
NoisyMap Part(const Shapes::Surface& surface, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 10.0);
  NoisyMap part{ "map", {}, {}, {} };
  for (const glm::dvec3& point : surface.points)
  {
    GroupValues groups;
    double mean = 0.0;
    for (double& group : groups)
    {
      group = std::max(0.0, 100.0 + 50.0 * point.x + noise(random));
      mean += group / double{ Groups };
    }
    part.groups.push_back(groups);
    part.values.push_back(mean);
  }
  return part;
}

void Measure(const Shapes::Surface& surface, const char* order, int threads)
{
  const std::vector<NoisyMap> parts{ Part(surface, 1), Part(surface, 2) };
  const std::vector<double> hits(surface.points.size(), 100.0);
  double graphSeconds = 0.0;
  double seconds = 0.0;
  Threads(threads).Run(
    [&]
    {
      const auto build = [&] { return SmoothingGraph(surface.points, surface.facets, 0.7); };
      graphSeconds = Measurement::Seconds([&] { build(); });
      const SmoothingGraph graph = build();
      seconds = Measurement::Seconds([&] { Filtrate(graph, parts, hits, {}, [](double) {}); });
    });
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("| %zu | %s | %.3f | %.3f | %.2f | %.2f |\n", surface.points.size(), order,
    graphSeconds, seconds, 1e6 * (graphSeconds + seconds) / double(surface.points.size()),
    static_cast<double>(usage.ru_maxrss) * 0x1p-20);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  std::vector<double> sizes{ 1e4, 1e5, 1e6, 5e6 };
  if (argc > 2)
  {
    sizes.clear();
    std::transform(argv + 2, argv + argc, std::back_inserter(sizes), std::atof);
  }
  std::printf(
    "| vertices | order | graph, s | filtration, s | together, us a vertex | peak, GiB |\n"
    "|---|---|---|---|---|---|\n");
  for (const double size : sizes)
  {
    const int cells = static_cast<int>(std::sqrt(size)) - 1;
    const Shapes::Surface square =
      Shapes::Rectangle({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, cells);
    Measure(square, "rows", threads);
    Measure(Shuffled(square), "random", threads);
  }
  return 0;
}
