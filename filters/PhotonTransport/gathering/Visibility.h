// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Incidence.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstddef>

namespace PhotonTransport
{

/// From a place where rays start to the place that light comes from.
struct ShadowRay
{
  glm::vec3 origin;
  Incidence light;
};

/// What reaches a point of the light that goes straight there, through clear panes too.
class Visibility
{
public:
  /// @param materials Must outlive this, as the scene must. @param switchedOn Light does not pass
  /// panes without Scattering::ClearTransmission.
  Visibility(const Scene& scene, const FacetRoulettes& materials, ScatteringSet switchedOn);

  static constexpr std::size_t Most = 64; ///< Rays at a time.

  /// The transmittance of each way, by channel: 0 where a facet stops the light. A ray near an edge
  /// may get either result, depending on its neighbours; see EmbreeScene::Intersect.
  /// @param count Up to Most.
  void Follow(const ShadowRay* rays, Colour* transmittances, std::size_t count) const;

private:
  Segment SegmentOf(const glm::vec3& origin, const Incidence& light) const;
  Colour ThroughPanes(const ShadowRay& ray) const;

  const Scene& LitScene;
  const FacetRoulettes& Materials;
  bool HasPanes;
};

} // namespace PhotonTransport
