// SPDX-License-Identifier: BSD-3-Clause
// How close the whole tracer comes to bare Embree: photon segments per second, registration,
// sampling and roulette included, over rtcIntersect1 calls per second on the very same rays.
//
//   TransportRatio [threads [mesh.vtp]]
//
// A mesh (VTK configuration only) is lit by its facets' Exitance, or else by a point lamp in the
// middle. It is traced flat, and as the curved surface that its normals tell of.
//
// The two are measured alternately; medians of the runs and of their quotients are printed.
#include "BareEmbree.h"
#include "Measurement.h"
#include "MeshFile.h"
#include "Shapes.h"

#include "PhotonTransport/scene/CurvedSurface.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Measurement::Median;
using Measurement::Seconds;

namespace
{

constexpr std::uint64_t Blocks = 2000;
constexpr std::uint64_t Photons = Blocks * PhotonBlock;
constexpr int Repetitions = 11;

void Compare(const std::string& name, const Surface& surface, const Lamp& lamp, int threads)
{
  const Scene scene(surface);
  TraceSettings settings;
  settings.threads = threads;
  PhotonTracer tracer(scene, lamp, settings);
  const std::vector<Ray> rays = Measurement::RecordRays(scene, lamp, settings, Photons);
  BareEmbree bare(scene, rays, threads);

  std::vector<double> traced, replayed, ratios;
  for (int repetition = 0; repetition < Repetitions; ++repetition)
  {
    IlluminationSums sums = tracer.EmptySums();
    const double all = Seconds([&] { tracer.Trace(0, 0, Blocks, sums); });
    const double replay = Seconds([&] { bare.Replay(); });
    traced.push_back(static_cast<double>(sums.Balance().segments) / all * 1e-6);
    replayed.push_back(static_cast<double>(rays.size()) / replay * 1e-6);
    ratios.push_back(traced.back() / replayed.back());
  }
  std::printf(
    "%-28s %9zu triangles  %d thread%s  all-in %6.2f M/s  bare Embree %6.2f M/s  ratio %.2f\n",
    name.c_str(), scene.Facets().size(), threads, threads == 1 ? " " : "s", Median(traced),
    Median(replayed), Median(ratios));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  if (argc > 2)
  {
    const Surface surface = ReadMesh(argv[2]);
    const glm::dvec3 middle = FitPlacement(surface.points, surface.facets).centre;
    const Lamp lamp =
      surface.exitance.empty() ? Lamp(PointLamp{ middle, 1000.0 }) : Lamp(EmittingFacets());
    Compare(std::string(argv[2]) + ", flat", surface, lamp, threads);
    Compare(std::string(argv[2]) + ", curved", CurvedSurface(surface), lamp, threads);
    return 0;
  }
  for (const int triangles : { 10'000, 100'000, 1'000'000 })
  {
    Compare("room with sphere, rho 0.5",
      Shapes::WithReflectance(Shapes::RoomWithSphere(triangles), 0.5f),
      PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 }, threads);
  }
  return 0;
}
