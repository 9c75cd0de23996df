// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Scene.h"

#include "PhotonTransport/scene/EmbreeScene.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace PhotonTransport
{
namespace
{

glm::vec3 PointAt(
  const glm::vec3& barycentric, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
  return a + barycentric.y * (b - a) + barycentric.z * (c - a);
}

} // namespace

// The two rare cases are functions of their own, so that the usual one needs no stack.

glm::vec3 Scene::SafeOrigin(const Hit& hit, bool front) const
{
  if (hit.part != NoPart)
  {
    return this->SafeOriginOnPart(hit, front);
  }
  const Facet& facet = this->FacetRecords[hit.facet];
  const glm::vec3 point = PointAt(hit.barycentric, this->VertexRecords[facet.vertices.x].position,
    this->VertexRecords[facet.vertices.y].position, this->VertexRecords[facet.vertices.z].position);
  return this->SafeOriginAt(point, hit, front);
}

[[gnu::noinline]] glm::vec3 Scene::SafeOriginOnPart(const Hit& hit, bool front) const
{
  if (hit.part == NoPartButLifted)
  {
    return this->SafeOrigin(hit.facet, hit.barycentric, front, hit.inPart.x);
  }
  const std::array<glm::vec3, 3>& corners = this->Bvh->Part(hit.part).positions;
  return this->SafeOriginAt(PointAt(hit.inPart, corners[0], corners[1], corners[2]), hit, front);
}

inline glm::vec3 Scene::SafeOriginAt(const glm::vec3& point, const Hit& hit, bool front) const
{
  const Facet& facet = this->FacetRecords[hit.facet];
  const float offset = OriginOffset * this->Reach(point);
  const float margin = facet.MarginPerOffset() * offset;
  if (std::min(std::min(hit.barycentric.x, hit.barycentric.y), hit.barycentric.z) < margin)
  {
    return this->SafeOrigin(hit.facet, hit.barycentric, front);
  }
  return point + (front ? offset : -offset) * facet.normal;
}

[[gnu::noinline]] glm::vec3 Scene::SafeOrigin(
  std::uint32_t f, const glm::vec3& barycentric, bool front, float lift) const
{
  const Facet& facet = this->FacetRecords[f];
  // In double, so that the start is rounded by its own coordinates and not by the facet's.
  const glm::dvec3 a(this->VertexRecords[facet.vertices.x].position);
  const glm::dvec3 toB = glm::dvec3(this->VertexRecords[facet.vertices.y].position) - a;
  const glm::dvec3 toC = glm::dvec3(this->VertexRecords[facet.vertices.z].position) - a;
  const auto at = [&](const glm::vec3& b) { return a + double{ b.y } * toB + double{ b.z } * toC; };
  // Clear of the facets in the same place, too.
  const float offset = OriginOffset * static_cast<float>(this->Reach(at(barycentric))) +
    this->ApartFromSharers(f) + lift;
  const float margin = std::min(1.0f / 3.0f, facet.MarginPerOffset() * offset);
  const glm::vec3 inside = glm::max(barycentric, margin);
  const glm::dvec3 point = at(inside / (inside.x + inside.y + inside.z));
  return glm::vec3(point + double{ front ? offset : -offset } * glm::dvec3(facet.normal));
}

} // namespace PhotonTransport
