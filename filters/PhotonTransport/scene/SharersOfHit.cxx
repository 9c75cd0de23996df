// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/SharedPlace.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace PhotonTransport
{
namespace
{

/// Barycentric coordinates of a point in a triangle, both seen along an axis; nothing for a point
/// outside. A point on the edge at which two triangles are joined is in exactly one of them.
std::optional<glm::vec3> Inside(const glm::dvec3& point, const glm::dvec3 (&corners)[3], int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto twiceArea = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
  { return (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]); };
  const double whole = twiceArea(corners[0], corners[1], corners[2]);
  glm::dvec3 parts;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& a = corners[(i + 1) % 3];
    const glm::dvec3& b = corners[(i + 2) % 3];
    // The same bits from both sides: the edge always runs from its lesser end.
    const bool swapped = b[u] < a[u] || (b[u] == a[u] && b[v] < a[v]);
    const double left = swapped ? twiceArea(b, a, point) : twiceArea(a, b, point);
    const bool isLeft = left >= 0.0;
    if (isLeft != ((whole > 0.0) != swapped))
    {
      return std::nullopt;
    }
    parts[i] = std::fabs(left);
  }
  const double sum = parts.x + parts.y + parts.z;
  return sum > 0.0 ? std::optional(glm::vec3(parts / sum)) : std::nullopt;
}

} // namespace

/// Where a hit is, and how far from there a facet may be that shares the place.
struct Scene::PlaceOfHit
{
  glm::dvec3 point;
  glm::vec3 normal; ///< Of the facet that was hit.
  double near;      ///< By rounding.
  double apart;     ///< As the facet that was hit and those in its place may be.
};

Scene::PlaceOfHit Scene::PlaceOf(const Hit& hit) const
{
  const Facet& met = this->FacetRecords[hit.facet];
  const glm::dvec3 weights(hit.barycentric);
  glm::dvec3 point(0.0);
  for (int c = 0; c < 3; ++c)
  {
    point += weights[c] / (weights.x + weights.y + weights.z) *
      glm::dvec3(this->VertexRecords[met.vertices[c]].position);
  }
  const double near = double{ SheetGap } * this->Reach(point) + double{ CornerGap };
  return { point, met.normal, near, double{ this->Apart[hit.facet] } };
}

/// The barycentric coordinates in a facet of a place that it shares, or nothing.
std::optional<glm::vec3> Scene::WithinShared(std::uint32_t f, const PlaceOfHit& place) const
{
  const Facet& facet = this->FacetRecords[f];
  if ((this->Shared[f] & SharesPlace) == 0 || !(glm::dot(place.normal, facet.normal) > SameSheet))
  {
    return std::nullopt;
  }
  const glm::dvec3 corners[3] = { glm::dvec3(this->VertexRecords[facet.vertices.x].position),
    glm::dvec3(this->VertexRecords[facet.vertices.y].position),
    glm::dvec3(this->VertexRecords[facet.vertices.z].position) };
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double gap = place.near + std::min(place.apart, double{ this->Apart[f] });
  return std::fabs(glm::dot(place.point - corners[0], normal)) <= gap * glm::length(normal)
    ? Inside(place.point, corners, BestAxis(place.normal))
    : std::nullopt;
}

void Scene::FindSharers(Hit& hit, std::vector<Sharer>& sharers) const
{
  sharers.clear();
  const PlaceOfHit place = this->PlaceOf(hit);
  const float lift = hit.part == NoPartButLifted ? hit.inPart.x : 0.0f; // see FindFront
  // Seen along the axis a facet may be farther from the point than its plane is.
  this->ForEachNear(glm::vec3(place.point), static_cast<float>(place.near + 2.0 * place.apart),
    [&](std::uint32_t f)
    {
      if (const auto there = this->WithinShared(f, place))
      {
        sharers.push_back({ f, *there, AllCorners & ~unsigned{ this->Shared[f] } });
      }
    });
  std::sort(sharers.begin(), sharers.end(),
    [](const Sharer& a, const Sharer& b) { return a.facet < b.facet; });
  sharers.erase(std::unique(sharers.begin(), sharers.end(),
                  [](const Sharer& a, const Sharer& b) { return a.facet == b.facet; }),
    sharers.end());
  if (sharers.size() < 2)
  {
    // The facet shares another part of its place, or rounding has put the point beside the others.
    sharers.assign(1, { hit.facet, hit.barycentric, AllCorners });
  }
  else if (sharers.back().facet != hit.facet)
  {
    hit.facet = sharers.back().facet;
    hit.barycentric = sharers.back().barycentric;
    hit.part = NoPart;
  }
  if (this->Apart[hit.facet] > 0.0f || lift > 0.0f)
  {
    hit.part = NoPartButLifted;
    hit.inPart = glm::vec3(lift);
  }
}

} // namespace PhotonTransport
