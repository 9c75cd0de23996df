// SPDX-License-Identifier: BSD-3-Clause
// What each effect costs a scene that calls for it, and what it saves not to simulate the others.
//
//   EffectCosts [threads [repetitions [table.csv]]]
//   EffectCosts count SCENE BLOCKS [general]
//
// Each scene is measured in turn with the scene that it is compared with, with itself through the
// walk that has every effect compiled in, and with bare Embree on the very same rays. A number is
// the median over the repetitions; the quartiles tell how quiet the machine was.
//
// With `count` it traces blocks of 256 photons on one thread and nothing else, for a tool that
// counts instructions; `general` takes the walk with every effect. See instructions.sh.
#include "BareEmbree.h"
#include "EffectScenes.h"
#include "Measurement.h"

#include "PhotonTransport/transport/IlluminationRun.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Measurement::Spread;

namespace
{

constexpr int Triangles = 20'000;
constexpr std::uint64_t Blocks = 1000; // of each measurement of a rate
constexpr double Target = 0.02;        // relative error
constexpr int RunsToTarget = 3;

const EffectScene& Named(const std::vector<EffectScene>& scenes, const std::string& name)
{
  const auto found = std::find_if(
    scenes.begin(), scenes.end(), [&](const EffectScene& scene) { return scene.name == name; });
  if (found == scenes.end())
  {
    throw std::invalid_argument("no scene is called \"" + name + "\"");
  }
  return *found;
}

/// A scene made ready to be traced.
struct Prepared
{
  Prepared(const EffectScene& description, int threads, bool general)
    : what(description)
    , scene(description.surface)
    , settings(description.settings)
  {
    this->settings.threads = threads;
    this->settings.mostGeneralWalk = general;
    this->tracer = std::make_unique<PhotonTracer>(this->scene, this->what.lighting, this->settings);
  }

  double Rate() { return Measurement::TraceRate(*this->tracer, Blocks); }

  const EffectScene& what;
  Scene scene;
  TraceSettings settings;
  std::unique_ptr<PhotonTracer> tracer;
};

/// What is told about a scene.
struct Row
{
  std::string scene, reference;
  double rate;           ///< Million segments a second.
  Spread cost;           ///< % of the reference's rate.
  Spread saved;          ///< % of the time that the general walk takes.
  Spread share;          ///< Of bare Embree's rate.
  double seconds;        ///< Of tracing until the error is below the target.
  double timesReference; ///< Over the reference's seconds.
};

double SecondsToTarget(const Prepared& prepared)
{
  IlluminationRun run(prepared.scene, prepared.what.lighting, prepared.settings);
  if (run.Advance({ 10'000'000'000, Target }) != StopReason::RelativeError)
  {
    throw std::runtime_error(prepared.what.name + " does not reach the target");
  }
  return run.Seconds();
}

Row Measure(const EffectScene& scene, const EffectScene& other, int threads, int repetitions)
{
  Prepared own(scene, threads, false);
  Prepared reference(other, threads, false);
  Prepared general(scene, threads, true);
  const std::vector<Ray> rays =
    Measurement::RecordRays(own.scene, scene.lighting, own.settings, Blocks * PhotonBlock);
  BareEmbree bare(own.scene, rays, threads);
  const auto bareRate = [&] {
    return static_cast<double>(rays.size()) / Measurement::Seconds([&] { bare.Replay(); }) * 1e-6;
  };
  const auto rates =
    Measurement::MeasureInTurn({ [&] { return own.Rate(); }, [&] { return reference.Rate(); },
                                 [&] { return general.Rate(); }, bareRate },
      repetitions);
  const auto seconds = Measurement::MeasureInTurn(
    { [&] { return SecondsToTarget(own); }, [&] { return SecondsToTarget(reference); } },
    RunsToTarget);
  return { scene.name, scene.reference, Measurement::Median(rates[0]),
    Measurement::CostOf(rates[0], rates[1]), Measurement::CostOf(rates[2], rates[0]),
    Spread(Measurement::Quotients(rates[0], rates[3])), Measurement::Median(seconds[0]),
    Measurement::Median(Measurement::Quotients(seconds[0], seconds[1])) };
}

std::string Number(double value, const char* format)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// "5.2 (4.8 to 6.0)"
std::string Text(const Spread& spread, const char* format)
{
  return Number(spread.median, format) + " (" + Number(spread.low, format) + " to " +
    Number(spread.high, format) + ")";
}

void PrintHead(const EffectScene& scene, int threads, int repetitions)
{
  std::printf("Room with sphere, %zu triangles; threads: %d; medians of %d, seconds of %d "
              "(quartiles)\n\n"
              "| scene | compared with | million segments/s | costs, %% of the rate | specialised "
              "walk saves, %% of the time | of bare Embree's rate | seconds to %g %% | times the "
              "reference's |\n|---|---|---|---|---|---|---|---|\n",
    scene.surface.facets.size(), threads, repetitions, RunsToTarget, 100.0 * Target);
}

void Print(const Row& row)
{
  const bool compared = row.scene != row.reference;
  std::printf("| %s | %s | %.2f | %s | %s | %s | %.2f | %s |\n", row.scene.c_str(),
    compared ? row.reference.c_str() : "", row.rate,
    compared ? Text(row.cost, "%+.1f").c_str() : "", Text(row.saved, "%+.1f").c_str(),
    Text(row.share, "%.2f").c_str(), row.seconds,
    compared ? Number(row.timesReference, "%.2f").c_str() : "");
  std::fflush(stdout);
}

void WriteCsv(const char* fileName, const std::vector<Row>& rows)
{
  std::ofstream file(fileName);
  file << "scene,compared with,million segments/s";
  for (const char* column : { "cost %", "saved %", "of bare Embree" })
  {
    file << ',' << column << ',' << column << " low," << column << " high";
  }
  file << ",seconds to 2 %,times the reference's\n";
  for (const Row& row : rows)
  {
    file << '"' << row.scene << "\",\"" << row.reference << "\"," << row.rate;
    for (const Spread& spread : { row.cost, row.saved, row.share })
    {
      file << ',' << spread.median << ',' << spread.low << ',' << spread.high;
    }
    file << ',' << row.seconds << ',' << row.timesReference << '\n';
  }
  file.close();
  if (!file)
  {
    throw std::runtime_error(std::string("cannot write ") + fileName);
  }
}

void Count(const EffectScene& scene, std::uint64_t blocks, bool general)
{
  Prepared own(scene, 1, general);
  IlluminationSums sums = own.tracer->EmptySums();
  own.tracer->Trace(0, 0, blocks, sums);
  std::printf("%llu segments\n", static_cast<unsigned long long>(sums.Balance().segments));
}

void MeasureAll(const std::vector<EffectScene>& scenes, int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 11;
  PrintHead(scenes.front(), threads, repetitions);
  std::vector<Row> rows;
  for (const EffectScene& scene : scenes)
  {
    rows.push_back(Measure(scene, Named(scenes, scene.reference), threads, repetitions));
    Print(rows.back());
  }
  if (argc > 3)
  {
    WriteCsv(argv[3], rows);
  }
}

} // namespace

int main(int argc, char* argv[])
try
{
  const std::vector<EffectScene> scenes = EffectScenes(Triangles);
  if (argc > 3 && std::string(argv[1]) == "count")
  {
    const bool general = argc > 4 && std::string(argv[4]) == "general";
    Count(Named(scenes, argv[2]), std::strtoull(argv[3], nullptr, 10), general);
  }
  else
  {
    MeasureAll(scenes, argc, argv);
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
