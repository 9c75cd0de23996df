// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/statistics/PhotonBalance.h"

#include <glm/geometric.hpp>

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// What photons walk through, and how far.
struct WalkSettings
{
  const Scene& scene;
  const Emitter& source;
  SequenceKey key;
  std::uint32_t longestPath; ///< Segments, >= 1.
};

/// A photon of unit energy on its way; its ray is kept apart, with those of the others.
struct Flight
{
  ScatteringNumbers numbers;
  std::uint32_t order; ///< Scatterings so far.
};

/// What happens to a photon at the end of a segment.
/// @tparam Interreflection Whether any facet of the scene reflects.
/// @param ray The segment; the next one if the photon goes on.
/// @param hit Its end; moved to the right one of two facets in the same place.
/// @param onHit Called as onHit(ray, hit, front, direct).
/// @return Whether it goes on.
template <bool Interreflection, class OnHit>
bool Arrive(Flight& photon, Ray& ray, Hit& hit, const WalkSettings& settings, const OnHit& onHit,
  PhotonBalance& balance)
{
  ++balance.segments;
  if (!hit)
  {
    ++balance.escaped;
    return false;
  }
  bool front = glm::dot(ray.direction, settings.scene.Facets()[hit.facet].normal) < 0.0f;
  front = front || settings.scene.PreferFront(ray, hit);
  const Facet& facet = settings.scene.Facets()[hit.facet];
  onHit(ray, hit, front, photon.order == 0);

  if constexpr (!Interreflection)
  {
    ++balance.absorbed;
    return false;
  }
  const ScatteringSample scattering = photon.numbers.At(photon.order);
  if (!Survives(facet.reflectance, scattering.survival))
  {
    ++balance.absorbed;
    return false;
  }
  if (++photon.order >= settings.longestPath)
  {
    ++balance.cutOff;
    return false;
  }
  // The path stays on the facets, which conserves photons; only registration is compensated.
  ray.origin = settings.scene.SafeOrigin(facet, hit.barycentric, front);
  ray.direction =
    ReflectDiffusely(front ? facet.normal : -facet.normal, scattering.u, scattering.v);
  return true;
}

/// Follows photons [first, last) of a sequence from emission to end.
///
/// Many at a time, for two reasons: Embree takes rays in packets, and the memory that one photon
/// waits for arrives while others are being traced. Sums do not depend on the order.
template <bool Interreflection, class OnHit>
void WalkPhotons(const WalkSettings& settings, std::uint64_t first, std::uint64_t last,
  const OnHit& onHit, PhotonBalance& balance)
{
  constexpr std::size_t Together = 64;
  std::array<Flight, Together> photons;
  std::array<Ray, Together> rays;
  std::array<Hit, Together> hits;
  std::size_t flying = 0;
  PhotonSample sample(settings.key, first);
  std::uint64_t next = first;
  do
  {
    for (; flying < Together && next < last; ++next, sample.Advance())
    {
      rays[flying] = settings.source.Emit(sample);
      photons[flying++] = { sample.Scatterings(), 0 };
      ++balance.emitted;
    }
    settings.scene.Intersect(rays.data(), hits.data(), flying);
    for (std::size_t i = 0; i < flying; ++i)
    {
      settings.scene.PrefetchFacet(hits[i]);
    }
    for (std::size_t i = 0; i < flying; ++i)
    {
      onHit.Prefetch(hits[i]);
    }
    std::size_t stillFlying = 0;
    for (std::size_t i = 0; i < flying; ++i)
    {
      if (Arrive<Interreflection>(photons[i], rays[i], hits[i], settings, onHit, balance))
      {
        photons[stillFlying] = photons[i];
        rays[stillFlying++] = rays[i];
      }
    }
    flying = stillFlying;
  } while (flying > 0 || next < last);
}

} // namespace PhotonTransport
