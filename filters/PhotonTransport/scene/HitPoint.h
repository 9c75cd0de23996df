// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>

#include <limits>

namespace PhotonTransport
{

/// Where a ray has met a facet, scene coordinates, for distances. Rays that go on from there start
/// at Scene::SafeOrigin.
inline glm::vec3 PointOf(const Scene& scene, const Hit& hit)
{
  const glm::uvec3& ids = scene.Facets()[hit.facet].vertices;
  return hit.barycentric.x * scene.Vertices()[ids.x].position +
    hit.barycentric.y * scene.Vertices()[ids.y].position +
    hit.barycentric.z * scene.Vertices()[ids.z].position;
}

/// The length of a ray, scene units; infinite if it has met nothing.
inline float DistanceTo(const Scene& scene, const Ray& ray, const Hit& hit)
{
  return hit ? glm::distance(ray.origin, PointOf(scene, hit))
             : std::numeric_limits<float>::infinity();
}

} // namespace PhotonTransport
