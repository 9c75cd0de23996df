// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/Walk.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

/// What the benchmarks share.
namespace Measurement
{

/// Seconds that some work takes.
template <typename Work>
double Seconds(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Million photon segments a second.
inline double TraceRate(PhotonTransport::PhotonTracer& tracer, std::uint64_t blocks)
{
  PhotonTransport::IlluminationSums sums = tracer.EmptySums();
  const double seconds = Seconds([&] { tracer.Trace(0, 0, blocks, sums); });
  return static_cast<double>(sums.Balance().segments) / seconds * 1e-6;
}

inline double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

inline double Median(const std::vector<double>& values)
{
  return Quantile(values, 0.5);
}

/// What repeated measurements say; the quartiles tell how quiet the machine was.
struct Spread
{
  explicit Spread(const std::vector<double>& values)
    : median(Median(values))
    , low(Quantile(values, 0.25))
    , high(Quantile(values, 0.75))
  {
  }

  double median, low, high;
};

/// Repetition by repetition.
inline std::vector<double> Quotients(
  const std::vector<double>& rates, const std::vector<double>& references)
{
  std::vector<double> quotients;
  for (std::size_t i = 0; i < rates.size(); ++i)
  {
    quotients.push_back(rates[i] / references[i]);
  }
  return quotients;
}

/// What is lost by one in place of the other, % of the other's rate.
inline Spread CostOf(const std::vector<double>& rates, const std::vector<double>& references)
{
  std::vector<double> costs = Quotients(rates, references);
  for (double& cost : costs)
  {
    cost = 100.0 * (1.0 - cost);
  }
  return Spread(costs);
}

/// Something that works once and says at which rate.
using RateOf = std::function<double()>;

/// Rates of several things that are measured in turn, forwards and backwards, so that what else
/// the machine does falls on all of them: [thing][repetition].
inline std::vector<std::vector<double>> MeasureInTurn(
  const std::vector<RateOf>& things, int repetitions)
{
  std::vector<std::vector<double>> rates(things.size());
  for (int repetition = -1; repetition < repetitions; ++repetition) // the first to warm up
  {
    for (std::size_t i = 0; i < things.size(); ++i)
    {
      const std::size_t thing = repetition % 2 == 0 ? i : things.size() - 1 - i;
      const double rate = things[thing]();
      if (repetition >= 0)
      {
        rates[thing].push_back(rate);
      }
    }
  }
  return rates;
}

/// Photon segments in the order in which single photons fly them.
struct Segment
{
  PhotonTransport::Ray ray;
  PhotonTransport::Hit hit;
  bool front = false;
  bool direct = false;
};

struct KeepHit
{
  Segment& segment;
  void operator()(const PhotonTransport::Ray&, const PhotonTransport::Hit&, bool front,
    const PhotonTransport::PhotonOrigin& origin, unsigned = PhotonTransport::AllCorners) const
  {
    this->segment.front = front;
    this->segment.direct = origin.direct;
  }
  void Finish() const {}
  void Arrived(const PhotonTransport::Hit&, bool, const PhotonTransport::PhotonOrigin&) const {}
};

/// The next photon's segments, from emission to end.
template <PhotonTransport::Walk WalkKind>
void RecordPhoton(const PhotonTransport::WalkSettings& walk,
  PhotonTransport::PhotonSequence& sample, std::vector<Segment>& segments)
{
  std::vector<PhotonTransport::PhotonBalance> balances(walk.source.Lamps());
  std::vector<PhotonTransport::Arrivals> arrivals(walk.source.Lamps());
  PhotonTransport::FlightBatch batch(walk.key);
  batch.Emit(walk.source, sample, 1, balances.data());
  while (batch.flying > 0)
  {
    Segment segment;
    segment.ray = batch.rays[0];
    walk.scene.Intersect(batch.rays.data(), batch.hits.data(), 1);
    PhotonTransport::ArriveAll<WalkKind>(
      batch, walk, KeepHit{ segment }, balances.data(), arrivals.data());
    segment.hit = batch.hits[0];
    segments.push_back(segment);
  }
}

/// The segments that the tracer flies, photon by photon.
inline std::vector<Segment> RecordSegments(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons)
{
  const PhotonTransport::Effects effects =
    PhotonTransport::AnalyseEffects(scene, lighting, settings);
  const PhotonTransport::Emitter emitter(lighting, scene, effects.colour);
  const PhotonTransport::SequenceKey key{ settings.seed, 0, settings.sampling };
  const PhotonTransport::FacetRoulettes materials = PhotonTransport::MakeRoulettes(
    scene.Materials(), scene.MaterialOfFacet(), effects.colouredFacets);
  const PhotonTransport::WalkSettings walk{ scene, materials, emitter, key,
    settings.maximumPathLength, effects.simulated, nullptr };
  const auto record = effects.present == SetOf(PhotonTransport::Scattering::DiffuseReflection) &&
      !effects.colouredFacets
    ? RecordPhoton<PhotonTransport::Walk::Diffuse>
    : RecordPhoton<PhotonTransport::Walk::General>;
  std::vector<Segment> segments;
  PhotonTransport::PhotonSequence sample(key, 0);
  for (std::uint64_t photon = 0; photon < photons; ++photon)
  {
    record(walk, sample, segments);
  }
  return segments;
}

/// Only the rays of RecordSegments.
inline std::vector<PhotonTransport::Ray> RecordRays(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons)
{
  std::vector<PhotonTransport::Ray> rays;
  for (const Segment& segment : RecordSegments(scene, lighting, settings, photons))
  {
    rays.push_back(segment.ray);
  }
  return rays;
}

} // namespace Measurement
