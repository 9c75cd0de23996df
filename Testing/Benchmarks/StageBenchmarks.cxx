// SPDX-License-Identifier: BSD-3-Clause
// Google Benchmark for each stage of a photon's path, on one thread. The argument of a benchmark is
// the number of triangles; items are photons, rays, hits or vertices.
#include "Measurement.h"
#include "Shapes.h"

#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr std::size_t Batch = 64; // as many as the walk keeps flying

const Lamp Bulb = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };

/// A scene and the segments of some photons in it.
struct Stage
{
  explicit Stage(int triangles)
    : scene(Shapes::WithExitance(
        Shapes::WithReflectance(Shapes::RoomWithSphere(triangles), 0.5f), 100.0f))
    , segments(Measurement::RecordSegments(this->scene, Bulb, TraceSettings(), 1 << 17))
  {
    this->segments.resize(this->segments.size() / Batch * Batch);
  }

  Scene scene;
  std::vector<Measurement::Segment> segments;
};

const Stage& StageOf(const benchmark::State& state)
{
  static std::map<std::int64_t, std::unique_ptr<Stage>> stages;
  std::unique_ptr<Stage>& stage = stages[state.range(0)];
  if (!stage)
  {
    stage = std::make_unique<Stage>(static_cast<int>(state.range(0)));
  }
  return *stage;
}

void CountItems(benchmark::State& state, std::size_t itemsPerIteration)
{
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(itemsPerIteration));
}

void Emission(benchmark::State& state, const Lamp& lamp, Sampling sampling)
{
  const Emitter emitter(lamp, StageOf(state).scene);
  PhotonSequence sample({ 1, 0, sampling }, 0);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(emitter.Emit(sample));
    sample.Advance();
  }
  CountItems(state, 1);
}
BENCHMARK_CAPTURE(Emission, Parallel, ParallelLight(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Point, Bulb, Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, PointRandom, Bulb, Sampling::Random)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, LambertianPoint, LambertianPointLamp(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Spot, SpotLamp(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Rectangle, RectangleLamp(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Disk, DiskLamp(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Sky, UniformSky(), Sampling::Sobol)->Arg(10'000);
BENCHMARK_CAPTURE(Emission, Facets, EmittingFacets(), Sampling::Sobol)
  ->Arg(10'000)
  ->Arg(100'000)
  ->Arg(1'000'000);

/// Rays in the order of the photons' flights, 64 a call.
void Intersection(benchmark::State& state)
{
  const Stage& stage = StageOf(state);
  std::vector<Ray> rays;
  for (const Measurement::Segment& segment : stage.segments)
  {
    rays.push_back(segment.ray);
  }
  std::vector<Hit> hits(Batch);
  std::size_t first = 0;
  for (auto _ : state)
  {
    stage.scene.Intersect(rays.data() + first, hits.data(), Batch);
    benchmark::DoNotOptimize(hits.data());
    benchmark::ClobberMemory();
    first = (first + Batch) % rays.size();
  }
  CountItems(state, Batch);
}
BENCHMARK(Intersection)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

/// Hits 64 at a time, memory fetched ahead as in the walk.
template <Registration RegistrationKind>
void RegistrationOf(benchmark::State& state)
{
  const Stage& stage = StageOf(state);
  IlluminationSums sums(stage.scene.Vertices().size(), false);
  const float startWeight = 1.0f;
  const Registrar<RegistrationKind, false> registrar(
    stage.scene, TraceSettings().weightBound, sums, &startWeight);
  std::size_t first = 0;
  for (auto _ : state)
  {
    const Measurement::Segment* batch = stage.segments.data() + first;
    for (std::size_t i = 0; i < Batch; ++i)
    {
      stage.scene.PrefetchFacet(batch[i].hit);
    }
    for (std::size_t i = 0; i < Batch; ++i)
    {
      registrar.Prefetch(batch[i].hit);
    }
    for (std::size_t i = 0; i < Batch; ++i)
    {
      registrar(batch[i].ray, batch[i].hit, batch[i].front, PhotonOrigin{ 0, 0, batch[i].direct });
    }
    registrar.Finish();
    first = (first + Batch) % stage.segments.size();
  }
  CountItems(state, Batch);
}
BENCHMARK_TEMPLATE(RegistrationOf, Registration::Flat)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK_TEMPLATE(RegistrationOf, Registration::FacetRatio)
  ->Arg(10'000)
  ->Arg(100'000)
  ->Arg(1'000'000);
BENCHMARK_TEMPLATE(RegistrationOf, Registration::VertexNormalised)
  ->Arg(10'000)
  ->Arg(100'000)
  ->Arg(1'000'000);

/// Mean and standard error of one vertex from eight replicates.
void Replicates(benchmark::State& state)
{
  double value = 0.0;
  for (auto _ : state)
  {
    ReplicateStatistics statistics;
    for (int replicate = 0; replicate < 8; ++replicate)
    {
      statistics.Add(value, 1000.0);
      value += 0.25;
    }
    benchmark::DoNotOptimize(statistics.StandardError());
  }
  CountItems(state, 1);
}
BENCHMARK(Replicates);

/// The whole map from the replicates' sums, on all cores; items are vertices.
void Statistics(benchmark::State& state)
{
  const Stage& stage = StageOf(state);
  IlluminationRun run(stage.scene, Bulb, TraceSettings());
  run.Advance({ 1'000'000 });
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(run.Front());
  }
  CountItems(state, stage.scene.Vertices().size());
}
BENCHMARK(Statistics)
  ->Arg(10'000)
  ->Arg(100'000)
  ->Arg(1'000'000)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

/// A block of photons from emission to end, registration included; items are segments.
void Block(benchmark::State& state)
{
  const Stage& stage = StageOf(state);
  const Emitter emitter(Bulb, stage.scene);
  const TraceSettings usual;
  const FacetRoulettes materials; // diffuse reflection only
  const WalkSettings walk{ stage.scene, materials, emitter, { usual.seed, 0, usual.sampling },
    usual.maximumPathLength, usual.scatterings, nullptr };
  IlluminationSums sums(stage.scene.Vertices().size(), false);
  const Registrar<Registration::VertexNormalised, false> registrar(
    stage.scene, usual.weightBound, sums, emitter.StartWeights().data());
  std::uint64_t first = 0;
  for (auto _ : state)
  {
    WalkPhotons<Walk::Diffuse>(
      walk, first, first + PhotonBlock, registrar, sums.balances.data(), sums.arrivals.data());
    first += PhotonBlock;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(sums.Balance().segments));
}
BENCHMARK(Block)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
