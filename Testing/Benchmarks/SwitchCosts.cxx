// SPDX-License-Identifier: BSD-3-Clause
// What each accuracy switch costs by itself, as a share of the photon segments per second.
//
//   SwitchCosts [threads [repetitions]]
//
// Each variant is measured in turn with what it is compared with, each first every other time; a
// cost is the median over the repetitions of the quotient of two neighbouring rates. The quartiles
// tell how quiet the machine was.
#include "BareEmbree.h"
#include "Measurement.h"
#include "Shapes.h"

#include "PhotonTransport/transport/IlluminationRun.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr std::uint64_t Blocks = 1000; // of each measurement but those of whole runs

/// Something that is measured, and what it is compared with.
struct Variant
{
  std::string name;
  std::size_t reference;               ///< Index of the variant that costs 0 %.
  Measurement::RateOf millionSegments; ///< Millions of segments a second.
};

/// The variants that trace the same blocks with other settings; the first is the default.
std::vector<Variant> Tracers(const Scene& scene, const Lamp& lamp, const TraceSettings& usual)
{
  TraceSettings flat = usual;
  flat.registration = Registration::Flat;
  TraceSettings ratio = usual;
  ratio.registration = Registration::FacetRatio;
  TraceSettings random = usual;
  random.sampling = Sampling::Random;
  TraceSettings back = usual;
  back.registerBackSide = true;
  const auto variant = [&](const char* name, const TraceSettings& settings)
  {
    auto tracer = std::make_shared<PhotonTracer>(scene, lamp, settings);
    return Variant{ name, 0, [tracer] { return Measurement::TraceRate(*tracer, Blocks); } };
  };
  return { variant("VertexNormalised, Sobol, front only", usual),
    variant("Flat registration instead", flat), variant("FacetRatio registration instead", ratio),
    variant("random instead of Sobol", random), variant("back side array too", back) };
}

/// One long sequence, bare, and a whole run of the same photons in 8 replicates with its
/// statistics.
void AddRuns(std::vector<Variant>& variants, const Scene& scene, const Lamp& lamp,
  const TraceSettings& settings, std::uint64_t millions)
{
  const std::uint64_t share = settings.replicates * PhotonBlock;
  const std::uint64_t blocks =
    (millions * 1'000'000 + share - 1) / share * settings.replicates; // as the run rounds up
  auto tracer = std::make_shared<PhotonTracer>(scene, lamp, settings);
  const std::string photons = std::to_string(millions) + " M photons, ";
  variants.push_back({ photons + "one sequence, no statistics", variants.size(),
    [tracer, blocks] { return Measurement::TraceRate(*tracer, blocks); } });
  const auto run = [&scene, lamp, settings, blocks]
  {
    IlluminationRun whole(scene, lamp, settings);
    const double seconds = Measurement::Seconds([&] { whole.Advance({ blocks * PhotonBlock }); });
    return static_cast<double>(whole.Balance().segments) / seconds * 1e-6;
  };
  variants.push_back({ photons + "8 replicates and statistics", variants.size() - 1, run });
}

/// Bare Embree with and without its robust flag.
void AddEmbree(std::vector<Variant>& variants, const Scene& scene, const Lamp& lamp,
  const TraceSettings& settings)
{
  const auto rays = std::make_shared<std::vector<Ray>>(
    Measurement::RecordRays(scene, lamp, settings, Blocks * PhotonBlock));
  const std::size_t reference = variants.size();
  for (const bool robust : { false, true })
  {
    auto embree = std::make_shared<BareEmbree>(scene, *rays, settings.threads, robust);
    variants.push_back({ robust ? "bare Embree, robust" : "bare Embree, not robust", reference,
      [embree, rays]
      {
        const double seconds = Measurement::Seconds([&] { embree->Replay(); });
        return static_cast<double>(rays->size()) / seconds * 1e-6;
      } });
  }
}

void PrintCost(const Variant& variant, const Variant& reference, int repetitions)
{
  const auto rates =
    Measurement::MeasureInTurn({ variant.millionSegments, reference.millionSegments }, repetitions);
  const Measurement::Spread cost = Measurement::CostOf(rates[0], rates[1]);
  std::printf("| %s | %s | %.2f | %.2f | %+.1f | %+.1f to %+.1f |\n", variant.name.c_str(),
    reference.name.c_str(), Measurement::Median(rates[0]), Measurement::Median(rates[1]),
    cost.median, cost.low, cost.high);
  std::fflush(stdout);
}

void Measure(int triangles, int threads, int repetitions)
{
  const Scene scene(Shapes::WithReflectance(Shapes::RoomWithSphere(triangles), 0.5f));
  const Lamp lamp = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };
  TraceSettings settings;
  settings.threads = threads;
  std::vector<Variant> variants = Tracers(scene, lamp, settings);
  AddRuns(variants, scene, lamp, settings, 1);
  AddRuns(variants, scene, lamp, settings, 4);
  AddEmbree(variants, scene, lamp, settings);

  std::printf("\nRoom with sphere, reflectance 0.5: %zu triangles, %zu vertices; threads: %d\n\n"
              "| variant | compared with | million segments/s | and | cost, %% of the rate | "
              "quartiles |\n|---|---|---|---|---|---|\n",
    scene.Facets().size(), scene.Vertices().size(), threads);
  for (std::size_t v = 0; v < variants.size(); ++v)
  {
    const Variant& reference = variants[variants[v].reference];
    if (&reference != &variants[v])
    {
      PrintCost(variants[v], reference, repetitions);
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 21;
  for (const int triangles : { 20'000, 100'000 })
  {
    Measure(triangles, threads, repetitions);
  }
  return 0;
}
