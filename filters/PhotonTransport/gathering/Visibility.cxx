// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/Visibility.h"

#include "PhotonTransport/materials/BackwardScattering.h"
#include "PhotonTransport/scene/SharedPlace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace PhotonTransport
{

Visibility::Visibility(
  const Scene& scene, const FacetRoulettes& materials, ScatteringSet switchedOn)
  : LitScene(scene)
  , Materials(materials)
  , HasPanes((switchedOn & SetOf(Scattering::ClearTransmission)) != 0 &&
      std::any_of(materials.roulettes.begin(), materials.roulettes.end(), IsPane))
{
}

Segment Visibility::SegmentOf(const glm::vec3& origin, const Incidence& light) const
{
  return std::isinf(light.distance) ? Segment{ { origin, light.towards }, light.distance }
                                    : this->LitScene.SegmentBetween(origin, light.place);
}

void Visibility::Follow(const ShadowRay* rays, Colour* transmittances, std::size_t count) const
{
  if (count == 0)
  {
    return;
  }
  std::array<Segment, Most> segments;
  std::array<std::uint8_t, Most> occluded;
  for (std::size_t i = 0; i < count; ++i)
  {
    segments[i] = this->SegmentOf(rays[i].origin, rays[i].light);
  }
  this->LitScene.FindOccluded(segments.data(), occluded.data(), count);
  for (std::size_t i = 0; i < count; ++i)
  {
    transmittances[i] = Colour(occluded[i] == 0 ? 1.0f : 0.0f);
    if (occluded[i] != 0 && this->HasPanes)
    {
      transmittances[i] = this->ThroughPanes(rays[i]);
    }
  }
}

/// For a way that meets something: follows it from pane to pane, as photons do that go on without
/// being deflected.
Colour Visibility::ThroughPanes(const ShadowRay& ray) const
{
  constexpr int MostPanes = 256; // it ends where rounding keeps a ray at one facet
  thread_local std::vector<Sharer> sharers;
  Colour transmittance(1.0f);
  glm::vec3 origin = ray.origin;
  for (int pane = 0; pane < MostPanes; ++pane)
  {
    const glm::vec3 towards = std::isinf(ray.light.distance)
      ? ray.light.towards
      : glm::vec3(glm::normalize(ray.light.place - glm::dvec3(origin)));
    const Ray onwards{ origin, towards };
    Hit hit;
    this->LitScene.Intersect(&onwards, &hit, 1);
    if (!hit)
    {
      return transmittance; // only rounding had found a facet
    }
    // The light comes the other way and meets the side that faces it.
    const Ray light{ origin, -towards };
    bool front = glm::dot(light.direction, this->LitScene.Facets()[hit.facet].normal) < 0.0f;
    front = front || this->LitScene.PreferFront(light, hit);
    if (this->LitScene.MaySharePlace(hit))
    {
      this->LitScene.FindSharers(hit, sharers);
    }
    const Roulette& material = this->Materials.roulettes[this->Materials.ofFacet[hit.facet]];
    if (!IsPane(material))
    {
      return Colour(0.0f);
    }
    const float cosine = std::fabs(glm::dot(towards, this->LitScene.Facets()[hit.facet].normal));
    transmittance *= PaneTransmittance(material, std::min(1.0f, cosine));
    origin = this->LitScene.SafeOrigin(hit, front);
    const Segment rest = this->SegmentOf(origin, ray.light);
    std::uint8_t occluded = 0;
    this->LitScene.FindOccluded(&rest, &occluded, 1);
    if (occluded == 0)
    {
      return transmittance;
    }
  }
  return Colour(0.0f);
}

} // namespace PhotonTransport
