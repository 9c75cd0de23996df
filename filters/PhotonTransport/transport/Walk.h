// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/FlightBatch.h"
#include "PhotonTransport/transport/OpeningPhotons.h"
#include "PhotonTransport/transport/PhotonArrival.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// What happens to all photons of a batch at the ends of their segments; see Arrive. Those that go
/// on stay in the batch.
/// @param balances, arrivals By source.
template <Walk WalkKind, class OnHit>
void ArriveAll(FlightBatch& batch, const WalkSettings& settings, const OnHit& onHit,
  PhotonBalance* balances, Arrivals* arrivals)
{
  if constexpr (WalkKind != Walk::Ends)
  {
    for (std::size_t i = 0; i < batch.flying; ++i)
    {
      batch.samples.Add(i, batch.photons[i].numbers, batch.photons[i].order);
    }
    batch.samples.Draw();
  }
  std::size_t left = 0;
  for (std::size_t i = 0; i < batch.flying; ++i)
  {
    Flight& photon = batch.photons[left] = batch.photons[i];
    Ray& ray = batch.rays[left] = batch.rays[i];
    const ScatteringSample& sample = batch.samples[i];
    const bool goesOn = Arrive<WalkKind>(photon, sample, ray, batch.hits[i], settings, onHit,
      balances[photon.origin.source], arrivals);
    if (WalkKind == Walk::Diffuse && goesOn)
    {
      batch.diffuse.Add(ray.direction, sample);
    }
    left += goesOn;
  }
  onHit.Finish();
  batch.flying = left;
  batch.diffuse.Reflect([&](std::size_t place, const glm::vec3& direction)
    { batch.rays[place].direction = direction; });
}

/// Finds the photons' hits, and brings each packet's facets into the cache while the next packet is
/// traced.
[[gnu::always_inline]] inline void Intersect(FlightBatch& batch, const Scene& scene)
{
  constexpr std::size_t Packet = 8;
  for (std::size_t first = 0; first < batch.flying; first += Packet)
  {
    const std::size_t count = std::min(Packet, batch.flying - first);
    scene.Intersect(&batch.rays[first], &batch.hits[first], count);
    for (std::size_t i = first; i < first + count; ++i)
    {
      scene.PrefetchFacet(batch.hits[i]);
    }
  }
}

/// Brings what else the photons' arrival will need into the cache.
template <class OnHit>
[[gnu::always_inline]] inline void PrefetchHits(const FlightBatch& batch, const OnHit& onHit)
{
  for (std::size_t i = 0; i < batch.flying; ++i)
  {
    onHit.Prefetch(batch.hits[i]);
  }
}

/// Follows photons [first, last) of a sequence from emission to end.
///
/// They are followed many at a time, for two reasons: Embree takes rays in packets, and the memory
/// that one photon waits for arrives while others are traced. Sums do not depend on the order.
/// @param balances, arrivals By source.
template <Walk WalkKind, class OnHit>
void WalkPhotons(const WalkSettings& settings, std::uint64_t first, std::uint64_t last,
  const OnHit& onHit, PhotonBalance* balances, Arrivals* arrivals)
{
  FlightBatch batch(settings.key);
  PhotonSequence sequence(settings.key, first);
  std::uint64_t next = first;
  do
  {
    const std::size_t onWay = batch.flying;
    const std::size_t started = std::min<std::size_t>(PhotonsTogether - onWay, last - next);
    batch.Emit(settings.source, sequence, started, balances);
    next += started;
    if (settings.openings)
    {
      batch.flying = settings.openings->Start(
        batch.photons.data(), batch.rays.data(), onWay, batch.flying, balances, arrivals);
    }
    Intersect(batch, settings.scene);
    if (settings.openings)
    {
      batch.flying = settings.openings->HandOver(batch.photons.data(), batch.rays.data(),
        batch.hits.data(), batch.flying, balances, arrivals);
    }
    PrefetchHits(batch, onHit);
    ArriveAll<WalkKind>(batch, settings, onHit, balances, arrivals);
  } while (batch.flying > 0 || next < last);
}

} // namespace PhotonTransport
