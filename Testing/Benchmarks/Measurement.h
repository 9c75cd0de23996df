// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/Walk.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
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

inline double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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
    const PhotonTransport::PhotonOrigin& origin) const
  {
    this->segment.front = front;
    this->segment.direct = origin.direct;
  }
};

/// The segments that the tracer flies, photon by photon.
inline std::vector<Segment> RecordSegments(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lamp& lamp, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons)
{
  const PhotonTransport::Emitter emitter(lamp, scene);
  const PhotonTransport::SequenceKey key{ settings.seed, 0, settings.sampling };
  const PhotonTransport::FacetRoulettes none; // diffuse reflection only
  const PhotonTransport::WalkSettings walk{ scene, none, emitter, key, settings.maximumPathLength,
    settings.scatterings };
  std::vector<Segment> segments;
  PhotonTransport::PhotonBalance balance;
  PhotonTransport::PhotonSample sample(key, 0);
  for (std::uint64_t photon = 0; photon < photons; ++photon, sample.Advance())
  {
    PhotonTransport::Flight flight{ sample.Scatterings(), 0, {} };
    Segment segment;
    PhotonTransport::Ray next = emitter.Emit(sample).ray;
    bool goesOn = true;
    while (goesOn)
    {
      segment.ray = next;
      scene.Intersect(&segment.ray, &segment.hit, 1);
      goesOn = PhotonTransport::Arrive<PhotonTransport::Walk::Diffuse>(
        flight, next, segment.hit, walk, KeepHit{ segment }, balance);
      segments.push_back(segment);
    }
  }
  return segments;
}

/// Only the rays of RecordSegments.
inline std::vector<PhotonTransport::Ray> RecordRays(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lamp& lamp, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons)
{
  std::vector<PhotonTransport::Ray> rays;
  for (const Segment& segment : RecordSegments(scene, lamp, settings, photons))
  {
    rays.push_back(segment.ray);
  }
  return rays;
}

} // namespace Measurement
