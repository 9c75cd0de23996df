// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/OpeningPhotons.h"

#include "PhotonTransport/scene/HitPoint.h"
#include "PhotonTransport/scene/SharedPlace.h"

#include <glm/geometric.hpp>

namespace PhotonTransport
{
OpeningPhotons::OpeningPhotons(const Scene& scene, const Emitter& source, const OutdoorWays& ways)
  : LitScene(scene)
  , Source(source)
  , Ways(ways)
  , Materials(MakeRoulettes(scene.Materials(), scene.MaterialOfFacet(), ways.colouredFacets))
{
}

std::size_t OpeningPhotons::Start(Flight* photons, Ray* rays, std::size_t first, std::size_t count,
  PhotonBalance* balances, Arrivals* arrivals) const
{
  thread_local std::vector<TracedBack> toTrace;
  toTrace.clear();
  std::size_t kept = first;
  const auto block = [&](const Flight& photon)
  {
    ++balances[photon.origin.source].blocked;
    ++arrivals[photon.origin.source].elsewhere;
  };
  for (std::size_t i = first; i < count; ++i)
  {
    if (this->Source.PartOf(photons[i].origin.source) == LightPart::Whole)
    {
      photons[kept] = photons[i];
      rays[kept++] = rays[i];
    }
    else if (rays[i].direction == glm::vec3(0.0f)) // not kept
    {
      block(photons[i]);
    }
    else
    {
      toTrace.push_back({ photons[i], rays[i], rays[i] });
    }
  }
  this->TraceBack(toTrace);
  for (const TracedBack& back : toTrace)
  {
    if (!back.starts)
    {
      block(back.photon);
      continue;
    }
    // What has arrived outdoors is counted by the photons of the Whole.
    arrivals[back.photon.origin.source].elsewhere += back.photon.origin.arrived;
    photons[kept] = back.photon;
    rays[kept++] = { back.start.origin, -back.start.direction };
  }
  return kept;
}

void OpeningPhotons::TraceBack(std::vector<TracedBack>& all) const
{
  thread_local std::vector<std::size_t> onWay;
  thread_local std::vector<Ray> rays;
  thread_local std::vector<Hit> hits;
  onWay.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    onWay[i] = i;
  }
  while (!onWay.empty())
  {
    rays.clear();
    for (const std::size_t i : onWay)
    {
      rays.push_back(all[i].ray);
    }
    hits.resize(rays.size());
    this->LitScene.Intersect(rays.data(), hits.data(), rays.size());
    std::size_t left = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      TracedBack& back = all[onWay[i]];
      this->Step(back, hits[i]);
      if (back.goesOn)
      {
        onWay[left++] = onWay[i];
      }
    }
    onWay.resize(left);
  }
}

/// What light that leaves along a ray has done at the end of the ray, by the laws for light that
/// comes along it, which are reciprocal.
void OpeningPhotons::Step(TracedBack& back, Hit hit) const
{
  const Scene& scene = this->LitScene;
  PhotonOrigin& origin = back.photon.origin;
  back.goesOn = false;
  const bool inwards = false; // light comes against the ray
  if (this->Source.ToSky().FirstCrossing(back.ray, inwards, DistanceTo(scene, back.ray, hit)))
  {
    return;
  }
  if (!hit)
  {
    back.starts = this->IsKept(back);
    return;
  }
  bool front = glm::dot(back.ray.direction, scene.Facets()[hit.facet].normal) < 0.0f;
  front = front || scene.PreferFront(back.ray, hit);
  if (scene.MaySharePlace(hit))
  {
    thread_local std::vector<Sharer> sharers;
    scene.FindSharers(hit, sharers);
  }
  const Roulette& material = this->Materials.roulettes[this->Materials.ofFacet[hit.facet]];
  const glm::vec3& normal = scene.Facets()[hit.facet].normal;
  // The shares of the channels after all scatterings do not depend on their order.
  const Departure departure = ScatterPhoton<AllScatterings>(material, origin,
    back.photon.numbers.At(back.photon.order), back.ray.direction, front ? normal : -normal, front);
  const bool straightOnly = this->Source.PartOf(origin.source) == LightPart::Straight;
  if (departure.absorbed || (this->Ways.switchedOn & SetOf(departure.how)) == 0 ||
    ++back.photon.order >= this->Ways.maximumPathLength || (straightOnly && !departure.undeflected))
  {
    return;
  }
  const bool arrivesOnFront = front == departure.sameSide; // seen along the light
  origin.arrived = origin.arrived || arrivesOnFront || !material.translucent;
  origin.direct = origin.direct && departure.undeflected;
  origin.undiffused = origin.undiffused && !IsDiffuse(departure.how);
  back.ray = { scene.SafeOrigin(hit, arrivesOnFront), departure.direction };
  back.goesOn = true;
}

bool OpeningPhotons::IsKept(const TracedBack& back) const
{
  const std::uint32_t source = back.photon.origin.source;
  const bool isStraight = this->Source.PartOf(source) == LightPart::Straight;
  return back.photon.origin.direct == isStraight &&
    back.photon.numbers.KeepingNumber() <
    this->Source.ThroughOpenings(source)->KeptFrom(back.ray.direction);
}

std::size_t OpeningPhotons::HandOver(Flight* photons, Ray* rays, Hit* hits, std::size_t count,
  PhotonBalance* balances, Arrivals* arrivals) const
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const PhotonOrigin& origin = photons[i].origin;
    if (this->IsHandedOver(photons[i], rays[i], hits[i]))
    {
      ++balances[origin.source].handedOver;
      const bool underWay = this->Ways.throughFacets ? !origin.arrived : photons[i].order == 0;
      arrivals[origin.source].elsewhere += underWay;
    }
    else
    {
      photons[kept] = photons[i];
      rays[kept] = rays[i];
      hits[kept++] = hits[i];
    }
  }
  return kept;
}

bool OpeningPhotons::IsHandedOver(const Flight& photon, const Ray& ray, const Hit& hit) const
{
  const std::uint32_t source = photon.origin.source;
  if (this->Source.PartOf(source) != LightPart::Whole ||
    !this->Source.HandsOver(source, photon.origin.direct))
  {
    return false;
  }
  const bool inwards = true;
  return this->Source.ToSky()
    .FirstCrossing(ray, inwards, DistanceTo(this->LitScene, ray, hit))
    .has_value();
}

} // namespace PhotonTransport
