// SPDX-License-Identifier: BSD-3-Clause
#include "GatheringTools.h"

#include "PhotonTransport/gathering/CellLengths.h"
#include "PhotonTransport/gathering/FinalGathering.h"
#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/VertexReceivers.h"
#include "PhotonTransport/transport/PhotonTracer.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace PhotonTransport;

TraceSettings GatheringSettings(std::uint32_t rays, std::uint32_t seed)
{
  TraceSettings settings;
  settings.method = Method::FinalGathering;
  settings.gatherRays = rays;
  settings.replicates = GatheredReplicates;
  settings.seed = seed;
  return settings;
}

IlluminationMap GatheredFront(const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings, std::uint64_t photons, const Openings& openings)
{
  IlluminationRun run(scene, lighting, settings, openings);
  run.Advance({ photons });
  return run.Front();
}

std::vector<double> GatheredAt(const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings, std::uint64_t photons, const std::vector<std::uint32_t>& places)
{
  const FacetCells cells(scene, CellLengths(scene), FacetCells::MostFor(scene.Facets().size()));
  PhotonTracer tracer(scene, lighting, settings, &cells);
  std::vector<IlluminationSums> sums;
  for (std::uint32_t r = 0; r < settings.replicates; ++r)
  {
    sums.push_back(tracer.EmptySums());
    tracer.Trace(r, 0, photons / PhotonBlock / settings.replicates, sums.back());
  }
  const LampCellCounts noLamps;
  PhotonCounts counts{ {}, noLamps };
  for (const IlluminationSums& replicate : sums)
  {
    counts.replicates.push_back(
      { &replicate.cells, static_cast<double>(replicate.Balance().emitted) });
  }
  const Openings none;
  FinalGathering second(scene, cells, tracer.Source(), none, tracer.EffectsInUse(),
    GatherSettings{ settings.seed, settings.maximumPathLength, false, false, settings.threads });
  const VertexReceivers receivers(scene, cells);
  GatheredMap map;
  map.Resize(places.size(), false, 0);
  const ReceiverList list{ 0, places.size(),
    [&](std::uint64_t place, bool front, Receiver& receiver)
    { receivers.Make(places[place], front, receiver); } };
  second.Run(counts, settings.gatherRays,
    [&](const GatherPass& pass)
    {
      std::vector<std::uint8_t> done;
      pass.Receive(list, true, {}, map, done);
    });
  std::transform(
    map.direct.begin(), map.direct.end(), map.gathered.begin(), map.direct.begin(), std::plus<>());
  return map.direct;
}

MeanAndError MeanOf(const std::vector<double>& values)
{
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  for (const double value : values)
  {
    squares += (value - sum / count) * (value - sum / count);
  }
  return { sum / count, std::sqrt(squares / (count - 1.0) / count) };
}

namespace
{

std::vector<double> MeansOverSeeds(const std::vector<std::vector<double>>& values)
{
  std::vector<double> means(values.front().size(), 0.0);
  for (const std::vector<double>& seed : values)
  {
    for (std::size_t p = 0; p < means.size(); ++p)
    {
      means[p] += seed[p] / static_cast<double>(values.size());
    }
  }
  return means;
}

} // namespace

ToldErrors CompareWithTold(const std::vector<std::vector<double>>& values,
  const std::vector<std::vector<double>>& errors, const std::vector<double>& expected)
{
  const auto seeds = static_cast<double>(values.size());
  const std::vector<double> exact = expected.empty() ? MeansOverSeeds(values) : expected;
  // Deviations from the mean of n values are smaller than those from what is expected.
  const double wider = expected.empty() ? seeds / (seeds - 1.0) : 1.0;
  const boost::math::students_t student(GatheredReplicates - 1.0);
  const double within = boost::math::quantile(student, 0.975);
  std::vector<double> squares, means(exact.size(), 0.0);
  ToldErrors result;
  for (std::size_t seed = 0; seed < values.size(); ++seed)
  {
    double sum = 0.0;
    for (std::size_t p = 0; p < exact.size(); ++p)
    {
      const double t = (values[seed][p] - exact[p]) / errors[seed][p];
      sum += t * t * wider;
      result.covered += (std::fabs(t) * std::sqrt(wider) <= within) / seeds;
      means[p] += t / seeds;
    }
    squares.push_back(sum / static_cast<double>(exact.size()));
  }
  result.square = MeanOf(squares);
  result.covered /= static_cast<double>(exact.size());
  for (const double mean : means)
  {
    result.largest = std::max(result.largest, std::fabs(mean) * std::sqrt(seeds));
  }
  return result;
}
