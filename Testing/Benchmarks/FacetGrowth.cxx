// SPDX-License-Identifier: BSD-3-Clause
// What grows with the number of triangles: seconds until a scene is ready, segments per second and
// bytes, each beside those of bare Embree.
//
//   FacetGrowth [threads [triangles...]]      writes a table; facet_growth.py draws it
//
// The room with a sphere, as in TransportRatio. Embree's build is that of the same triangles in
// buffers of its own. Rates are measured alternately, also of the same mesh with points and
// triangles in random order; medians are printed. Bytes are those that the process takes more while
// a run of 8 replicates makes a map and the error of facet size, the Surface included, and what
// MemoryNeed told of them: a filter's arrays are in neither.
#include "BareEmbree.h"
#include "Measurement.h"
#include "ProcessMemory.h"
#include "Shapes.h"

#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/MemoryBudget.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Measurement::Median;
using Measurement::Seconds;
using namespace ProcessMemory;

namespace
{

constexpr std::uint64_t Blocks = 2000;
constexpr int Repetitions = 7;
const Lamp Light = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };

template <typename T>
double BytesOf(const std::vector<T>& array)
{
  return static_cast<double>(array.size() * sizeof(T));
}

struct Bytes
{
  double taken, told;
};

/// What a Surface takes and a run makes of it at most.
Bytes BytesOfRun(const Surface& surface, const TraceSettings& settings)
{
  GiveBack();
  ForgetPeak();
  const double before = Status("VmRSS:");
  MemoryBudget memory(MemoryNeed(surface, Light, settings), {}, MemoryLimit());
  {
    const Scene scene(surface);
    IlluminationRun run(scene, Light, settings, {}, &memory);
    StopRules rules;
    rules.photons = 2 * surface.points.size();
    run.Advance(rules);
    run.FacetErrorOf(run.Front());
  }
  const double ofSurface = BytesOf(surface.points) + BytesOf(surface.normals) +
    BytesOf(surface.facets) + BytesOf(surface.materialOfFacet);
  return { Status("VmHWM:") - before + ofSurface, static_cast<double>(memory.Bytes()) };
}

/// The same triangles, points and triangles in random order.
Surface Shuffled(const Surface& surface)
{
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> place(surface.points.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  Surface shuffled = surface;
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    shuffled.points[place[p]] = surface.points[p];
    shuffled.normals[place[p]] = surface.normals[p];
  }
  for (glm::uvec3& facet : shuffled.facets)
  {
    facet = { place[facet.x], place[facet.y], place[facet.z] };
  }
  std::shuffle(shuffled.facets.begin(), shuffled.facets.end(), random);
  return shuffled;
}

void Measure(int triangles, int threads)
{
  const Surface surface = Shapes::WithReflectance(Shapes::RoomWithSphere(triangles), 0.5f);
  TraceSettings settings;
  settings.threads = threads;
  settings.replicates = 8;
  const Bytes bytes = BytesOfRun(surface, settings);

  double ready = 0.0, built = 0.0, rate = 0.0, bareRate = 0.0, ratio = 0.0, order = 0.0;
  {
    std::vector<double> readies, builds, rates, bares, ratios, orders;
    for (int repetition = 0; repetition < 3; ++repetition)
    {
      std::unique_ptr<Scene> scene;
      readies.push_back(Seconds([&] { scene = std::make_unique<Scene>(surface); }));
      builds.push_back(Seconds([&] { const BareEmbree bare(*scene, {}, threads); }));
    }
    const Scene scene(surface), other(Shuffled(surface));
    PhotonTracer tracer(scene, Light, settings), tracerOfOther(other, Light, settings);
    const std::vector<Ray> rays =
      Measurement::RecordRays(scene, Light, settings, Blocks * PhotonBlock);
    BareEmbree bare(scene, rays, threads);
    for (int repetition = 0; repetition < Repetitions; ++repetition)
    {
      rates.push_back(Measurement::TraceRate(tracer, Blocks));
      bares.push_back(static_cast<double>(rays.size()) / Seconds([&] { bare.Replay(); }) * 1e-6);
      ratios.push_back(rates.back() / bares.back());
      orders.push_back(Measurement::TraceRate(tracerOfOther, Blocks) / rates.back());
    }
    ready = Median(readies), built = Median(builds), rate = Median(rates), bareRate = Median(bares);
    ratio = Median(ratios), order = Median(orders);
  }
  std::printf("%zu,%zu,%.3f,%.3f,%.2f,%.2f,%.2f,%.2f,%.0f,%.0f\n", surface.facets.size(),
    surface.points.size(), ready, built, rate, bareRate, ratio, order, bytes.taken, bytes.told);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  std::printf("triangles,points,ready s,Embree's build s,million segments/s,bare Embree's,ratio,"
              "random order,bytes,bytes told\n");
  std::vector<int> sizes = { 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000 };
  if (argc > 2)
  {
    sizes.clear();
  }
  for (int i = 2; i < argc; ++i)
  {
    sizes.push_back(std::atoi(argv[i]));
  }
  TraceSettings settings;
  settings.threads = threads;
  BytesOfRun(Shapes::WithReflectance(Shapes::RoomWithSphere(1000), 0.5f), settings); // libraries
  for (const int triangles : sizes)
  {
    Measure(triangles, threads);
  }
  return 0;
}
