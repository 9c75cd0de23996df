// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/registration/Arrivals.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/registration/PhotonBalance.h"
#include "PhotonTransport/registration/PhotonHit.h"
#include "PhotonTransport/registration/Registrar.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/Flight.h"

#include <glm/geometric.hpp>

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace PhotonTransport
{

class OpeningPhotons;

/// What the walk that is compiled lets photons do at facets.
enum class Walk
{
  Ends,       ///< Every photon ends where it first arrives.
  Diffuse,    ///< Facets reflect diffusely, all channels alike.
  Reflecting, ///< Facets reflect in every way, by channel.
  General     ///< Facets also let light through.
};
constexpr unsigned Walks = 4;

constexpr ScatteringSet CompiledIn(Walk walk)
{
  constexpr ScatteringSet Diffuse = SetOf(Scattering::DiffuseReflection);
  constexpr ScatteringSet Sets[Walks] = { 0, Diffuse, Diffuse | Reflections, AllScatterings };
  return Sets[static_cast<unsigned>(walk)];
}

/// What photons walk through, and how far.
struct WalkSettings
{
  const Scene& scene;
  const FacetRoulettes& materials; ///< Empty for Walk::Ends and Walk::Diffuse.
  const Emitter& source;
  SequenceKey key;
  std::uint32_t maximumPathLength; ///< Segments, >= 1.
  ScatteringSet switchedOn;        ///< Effects that are simulated.
  const FacetCells* cells;         ///< To count light by; null where vertices take all of it.
  /// For light that comes through openings; null where there is none.
  const OpeningPhotons* openings = nullptr;
};

/// What a photon does at the end of a segment, by its material. It takes the colour that this gives
/// it. In Walk::Diffuse the direction is the normal: the photon's own is found later.
template <Walk WalkKind>
Departure Depart(Flight& photon, const ScatteringSample& sample, const Ray& ray, const Hit& hit,
  bool front, const WalkSettings& settings)
{
  const Facet& facet = settings.scene.Facets()[hit.facet];
  const glm::vec3 normal = front ? facet.normal : -facet.normal;
  if constexpr (WalkKind == Walk::Diffuse)
  {
    Departure departure;
    departure.absorbed = !Survives(facet.reflectance, sample.survival);
    departure.direction = normal;
    return departure;
  }
  else
  {
    const Roulette& material = settings.materials.roulettes[settings.materials.ofFacet[hit.facet]];
    return ScatterPhoton<CompiledIn(WalkKind)>(
      material, photon.origin, sample, ray.direction, normal, front);
  }
}

constexpr bool LetsLightThrough(Walk walk)
{
  return (CompiledIn(walk) & Transmissions) != 0;
}

/// Counts a photon that had not arrived before by the side that it has met; see Arrivals.
/// @return Whether it has arrived, which it has not on the back of a facet that lets light through.
template <Walk WalkKind>
bool CountArrival(const Hit& hit, bool front, const WalkSettings& settings, Arrivals& arrivals)
{
  if constexpr (LetsLightThrough(WalkKind))
  {
    if (!front && settings.materials.roulettes[settings.materials.ofFacet[hit.facet]].translucent)
    {
      return false;
    }
  }
  ++(front ? arrivals.front : arrivals.back);
  return true;
}

/// Registers a photon on all facets in the place where it arrives, and moves the hit to the facet
/// that decides what becomes of it. It is not inlined, since it is rare and the hot code must stay
/// small.
template <class OnHit>
[[gnu::noinline]] void RegisterOnAll(const Scene& scene, const Ray& ray, Hit& hit, bool front,
  const PhotonOrigin& origin, const OnHit& onHit)
{
  thread_local std::vector<Sharer> sharers;
  scene.FindSharers(hit, sharers);
  for (const Sharer& sharer : sharers)
  {
    if (sharer.corners != 0)
    {
      onHit(ray, { sharer.facet, sharer.barycentric }, front, origin, sharer.corners);
    }
  }
}

/// Whether what is called at hits has a member Keep(PhotonHit) const.
template <class OnHit, class = void>
constexpr bool KeepsHits = false;
template <class OnHit>
constexpr bool KeepsHits<OnHit, std::void_t<decltype(&OnHit::Keep)>> = true;

/// Hands the end of a segment over to who keeps them.
template <class OnHit>
void Keep(const Flight& photon, const Ray& ray, const Hit& hit, bool front, const OnHit& onHit)
{
  if constexpr (KeepsHits<OnHit>)
  {
    onHit.Keep({ photon.numbers.photonIndex, hit.facet, hit.barycentric, ray.direction,
      photon.order, photon.origin.source, photon.origin.shares, front });
  }
}

/// What happens to a photon at the end of a segment.
/// @param sample What decides where it goes on.
/// @param ray The segment; the next one if the photon goes on, but in Walk::Diffuse with the normal
/// in place of the direction.
/// @param hit Its end; moved to another facet where that one lies in the same place and counts.
/// @param onHit Called as onHit(ray, hit, front, photon.origin, corners); without `corners` all
/// corners of the facet count. After that onHit.Arrived(hit, front, photon.origin) is called
/// once, unless the photon's path ends here for its length, and after all photons of a batch
/// onHit.Finish(). See Keep, too.
/// @param arrivals By source.
/// @return Whether it goes on.
template <Walk WalkKind, class OnHit>
bool Arrive(Flight& photon, const ScatteringSample& sample, Ray& ray, Hit& hit,
  const WalkSettings& settings, const OnHit& onHit, PhotonBalance& balance, Arrivals* arrivals)
{
  ++balance.segments;
  bool underWay = WalkKind == Walk::Ends ||
    (LetsLightThrough(WalkKind) ? !photon.origin.arrived : photon.order == 0);
  if (!hit)
  {
    Keep(photon, ray, hit, false, onHit);
    ++balance.escaped;
    if (underWay)
    {
      ++arrivals[photon.origin.source].escaped;
    }
    return false;
  }
  bool front = glm::dot(ray.direction, settings.scene.Facets()[hit.facet].normal) < 0.0f;
  if (!front)
  {
    front = settings.scene.PreferFront(ray, hit);
    balance.onBacks += !front;
  }
  if (settings.scene.MaySharePlace(hit))
  {
    RegisterOnAll(settings.scene, ray, hit, front, photon.origin, onHit);
  }
  else
  {
    onHit(ray, hit, front, photon.origin);
  }
  Keep(photon, ray, hit, front, onHit);
  if (photon.order + 1 < settings.maximumPathLength)
  {
    onHit.Arrived(hit, front, photon.origin);
  }
  if (underWay)
  {
    underWay = !CountArrival<WalkKind>(hit, front, settings, arrivals[photon.origin.source]);
    if constexpr (LetsLightThrough(WalkKind))
    {
      photon.origin.arrived = !underWay;
    }
  }
  // Beyond here only walks that let light through have photons that have not arrived.
  [[maybe_unused]] const auto countEnd = [&](std::uint64_t Arrivals::*end)
  {
    if (LetsLightThrough(WalkKind) && underWay)
    {
      ++(arrivals[photon.origin.source].*end);
    }
  };

  if constexpr (WalkKind == Walk::Ends)
  {
    ++balance.absorbed;
    return false;
  }
  else
  {
    const Departure departure = Depart<WalkKind>(photon, sample, ray, hit, front, settings);
    if (departure.absorbed)
    {
      ++balance.absorbed;
      countEnd(&Arrivals::absorbed);
      return false;
    }
    if ((settings.switchedOn & SetOf(departure.how)) == 0)
    {
      ++balance.cutOff;
      countEnd(&Arrivals::cutOff);
      ++balance.switchedOff[static_cast<unsigned>(departure.how)];
      return false;
    }
    if (++photon.order >= settings.maximumPathLength)
    {
      ++balance.cutOff;
      countEnd(&Arrivals::cutOff);
      return false;
    }
    photon.origin.direct = photon.origin.direct && departure.undeflected;
    photon.origin.undiffused = photon.origin.undiffused && !IsDiffuse(departure.how);
    // The path stays on the flat facets, which conserves photons. Only registration is compensated.
    ray.origin = settings.scene.SafeOrigin(hit, front == departure.sameSide);
    ray.direction = departure.direction;
    return true;
  }
}

} // namespace PhotonTransport
