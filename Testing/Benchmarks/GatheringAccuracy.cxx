// SPDX-License-Identifier: BSD-3-Clause
// How exact maps are at single points, and how long they take.
//
//   GatheringAccuracy reference SCENE|all FOLDER [coarser [threads]]    makes FOLDER/SCENE.bin
//   GatheringAccuracy show SCENE|all FOLDER                             what that file says
//   GatheringAccuracy run SCENE|all FOLDER PHOTONS [repetitions [threads [WAY [rays]]]]
//
// WAY is smoothed, photon-openings (told of openings), photon-openings-smoothed, gathered (by the
// second pass), gathered-smoothed or openings (gathered, told of openings). A reference with errors
// `coarser` times those that its scene asks for takes less time, by the square of that.
//
// for example: GatheringAccuracy run room /tmp/reference 1000000 5 2. Scenes are in
// ReferenceScenes.h. The cabin needs FOLDER/cabin.mesh, which cabin_mesh.py writes.
#include "MapErrors.h"
#include "Measurement.h"
#include "ReferenceFile.h"
#include "ReferenceScenes.h"

#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <string>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr unsigned PilotWaves = 16;
constexpr unsigned LeastWaves = 10, MostWaves = 400;
constexpr std::uint64_t PilotSeeds = 0x50696c6f74u, Seeds = 0x5365656473u;

/// Estimates of the light at vertices, on all threads. @param waves One a vertex.
std::vector<PointEstimate> Estimates(const PointReference& reference,
  const std::vector<ReferencePoint>& points, const std::vector<std::uint32_t>& vertices,
  const std::vector<unsigned>& waves, std::uint64_t seeds)
{
  std::vector<PointEstimate> estimates(vertices.size());
  ForEach(
    vertices.size(),
    [&](std::size_t i)
    {
      const std::uint32_t v = vertices[i];
      estimates[i] = reference.At(points[v], waves[i], (seeds << 24u) + v);
    },
    1);
  return estimates;
}

/// How many waves a point needs. The pilot's own samples are thrown away: an estimate that goes on
/// until its own error is small would be biased.
std::vector<unsigned> WavesFor(const std::vector<PointEstimate>& pilots, double target)
{
  std::vector<unsigned> waves;
  for (const PointEstimate& pilot : pilots)
  {
    const double ratio =
      pilot.illuminance > 0.0 ? pilot.standardError / (target * pilot.illuminance) : 0.0;
    const double wanted = std::ceil(PilotWaves * ratio * ratio);
    waves.push_back(
      std::max(LeastWaves, static_cast<unsigned>(std::min(wanted, double{ MostWaves }))));
  }
  return waves;
}

/// The first so many points that have more than 1 lx, with their pilots.
void KeepLit(
  std::size_t lit, std::vector<std::uint32_t>& vertices, std::vector<PointEstimate>& pilots)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < vertices.size() && kept < lit; ++i)
  {
    if (pilots[i].illuminance > 1.0)
    {
      vertices[kept] = vertices[i];
      pilots[kept++] = pilots[i];
    }
  }
  vertices.resize(kept);
  pilots.resize(kept);
}

void MakeReference(const std::string& name, const std::string& folder, double coarser)
{
  const ReferenceScene what = MakeReferenceScene(name, folder);
  StoredReference stored;
  stored.seconds = Measurement::Seconds(
    [&]
    {
      const Scene scene(what.surface);
      const PointReference reference(scene, what.lighting, what.guides);
      const std::vector<ReferencePoint> points = ReferencePoints(scene);
      std::vector<std::uint32_t> vertices = what.points;
      if (what.lit > 0) // some are dark
      {
        vertices.resize(std::min(vertices.size(), 2 * what.lit));
      }
      std::vector<PointEstimate> pilots = Estimates(reference, points, vertices,
        std::vector<unsigned>(vertices.size(), PilotWaves), PilotSeeds);
      if (what.lit > 0)
      {
        KeepLit(what.lit, vertices, pilots);
      }
      const std::vector<unsigned> waves = WavesFor(pilots, coarser * what.target);
      stored.estimates = Estimates(reference, points, vertices, waves, Seeds);
      stored.vertices = vertices;
    });
  Store(stored, folder + "/" + name + ".bin");
}

void Show(const std::string& name, const std::string& folder)
{
  const ReferenceScene what = MakeReferenceScene(name, folder);
  const StoredReference stored = LoadReference(folder + "/" + name + ".bin");
  const std::vector<std::size_t> points = ComparablePoints(stored, what.lit > 0);
  const ReferenceQuality quality = QualityOf(stored, points);
  std::printf("%s: %zu of %zu points, mean %.5g lx, own error: RMS %.3f %% of the mean; relative "
              "median %.3f, RMS %.3f, most %.2f %%; made in %.0f s\n",
    name.c_str(), points.size(), stored.vertices.size(), quality.mean, quality.rms, quality.median,
    quality.relativeRms, quality.most, stored.seconds);
}

void PrintErrors(const std::string& start, const MapErrors& e)
{
  std::printf("| %s | %zu | %.2f | %+.2f | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f |\n",
    start.c_str(), e.points, e.rms, e.bias, e.told, e.medianRelative, e.rmsRelative, e.rmsOfUnits,
    e.within2, e.within3);
}

std::string WordOf(const MapSettings& settings)
{
  return std::string(settings.gathered ? ", gathered" : "") +
    (settings.openings ? ", openings" : "") + (settings.smoothed ? ", smoothed" : "");
}

void Run(const std::string& name, const std::string& folder, MapSettings settings, int repetitions)
{
  const ReferenceScene what = MakeReferenceScene(name, folder);
  const StoredReference stored = LoadReference(folder + "/" + name + ".bin");
  const std::vector<std::size_t> points = ComparablePoints(stored, what.lit > 0);
  std::vector<MeasuredMap> maps;
  std::vector<double> seconds, secondsOfScene;
  for (int r = 0; r < repetitions; ++r)
  {
    maps.push_back(MakeMap(what, settings));
    seconds.push_back(maps.back().seconds);
    secondsOfScene.push_back(maps.back().secondsOfScene);
    ++settings.seed;
  }
  const std::string how =
    name + " | " + std::to_string(settings.photons) + WordOf(settings) + " | ";
  char times[64];
  std::snprintf(times, sizeof(times), "%.3f | %.3f", Measurement::Median(seconds),
    Measurement::Median(secondsOfScene));
  PrintErrors(how + "all | " + times, ErrorsOf(maps, stored, points));
  PrintErrors(
    how + "inner | " + times, ErrorsOf(maps, stored, InnerPoints(what.surface, stored, points)));
}

void PrintHead()
{
  std::printf(
    "| scene | photons | points | s | of these for the scene | number | RMS, %% of the mean "
    "| bias, %% | told, %% | relative error, median, %% | RMS, %% | error over told, RMS | "
    "within 2, %% | within 3, %% |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

int Usage()
{
  std::fprintf(stderr, "GatheringAccuracy reference|show|run SCENE FOLDER ..., see the source\n");
  return 2;
}

int Obey(const std::vector<std::string>& words)
{
  const auto number = [&](std::size_t i, double otherwise)
  { return i < words.size() ? std::atof(words[i].c_str()) : otherwise; };
  if (words.size() < 3)
  {
    return Usage();
  }
  const std::vector<std::string> names =
    words[1] == "all" ? ReferenceSceneNames() : std::vector<std::string>{ words[1] };
  if (words[0] == "run" && words.size() > 3)
  {
    PrintHead();
  }
  for (const std::string& name : names)
  {
    if (words[0] == "reference")
    {
      Threads(static_cast<int>(number(4, 0.0)))
        .Run([&] { MakeReference(name, words[2], number(3, 1.0)); });
      Show(name, words[2]);
    }
    else if (words[0] == "show")
    {
      Show(name, words[2]);
    }
    else if (words[0] == "run" && words.size() > 3)
    {
      MapSettings settings;
      settings.photons = static_cast<std::uint64_t>(number(3, 0.0));
      settings.threads = static_cast<int>(number(5, 2.0));
      const std::string way = words.size() > 6 ? words[6] : "";
      const auto is = [&](std::initializer_list<const char*> ways)
      { return std::find(ways.begin(), ways.end(), way) != ways.end(); };
      settings.smoothed = is({ "smoothed", "gathered-smoothed", "photon-openings-smoothed" });
      settings.openings = is({ "openings", "photon-openings", "photon-openings-smoothed" });
      settings.gathered = is({ "gathered", "gathered-smoothed", "openings" });
      settings.rays = static_cast<std::uint32_t>(number(7, 0.0));
      Run(name, words[2], settings, std::max(1, static_cast<int>(number(4, 3.0))));
    }
    else
    {
      return Usage();
    }
    std::fflush(stdout);
  }
  return 0;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    return Obey({ argv + 1, argv + argc });
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
