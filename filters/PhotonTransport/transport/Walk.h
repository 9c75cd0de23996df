// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/statistics/PhotonBalance.h"

#include <glm/geometric.hpp>

#include <cstdint>

namespace PhotonTransport
{

/// Follows one photon of unit energy from its emission to its end.
/// @tparam Interreflection Whether any facet of the scene reflects.
/// @param onHit Called as onHit(ray, hit, front, direct) at each hit.
template <bool Interreflection, class OnHit>
void WalkPhoton(const Scene& scene, Ray ray, const PhotonSample& sample, std::uint32_t longestPath,
  const OnHit& onHit, PhotonBalance& balance)
{
  ++balance.emitted;
  for (std::uint32_t order = 0;; ++order)
  {
    ++balance.segments;
    const Hit hit = scene.Intersect(ray);
    if (!hit)
    {
      ++balance.escaped;
      return;
    }
    const Facet& facet = scene.Facets()[hit.facet];
    const bool front = glm::dot(ray.direction, facet.normal) < 0.0f;
    onHit(ray, hit, front, order == 0);

    if constexpr (!Interreflection)
    {
      ++balance.absorbed;
      return;
    }
    const ScatteringSample scattering = sample.Scattering(order);
    if (!Survives(facet.reflectance, scattering.survival))
    {
      ++balance.absorbed;
      return;
    }
    if (order + 1 >= longestPath)
    {
      ++balance.cutOff;
      return;
    }
    // The path stays on the facets, which conserves photons; only registration is compensated.
    ray.origin = scene.SafeOrigin(facet, hit.barycentric, front);
    ray.direction =
      ReflectDiffusely(front ? facet.normal : -facet.normal, scattering.u, scattering.v);
  }
}

} // namespace PhotonTransport
