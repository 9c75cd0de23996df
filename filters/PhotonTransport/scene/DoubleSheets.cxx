// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/DoubleSheets.h"

#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

std::optional<glm::vec3> Within(const glm::dvec3& point, double gap, const glm::dvec3& a,
  const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 normal = glm::cross(b - a, c - a); // of twice the area
  const double twiceArea = glm::length(normal);
  if (std::fabs(glm::dot(point - a, normal)) > gap * twiceArea)
  {
    return std::nullopt;
  }
  const auto share = [&](const glm::dvec3& from, const glm::dvec3& to)
  {
    const double part = glm::dot(glm::cross(to - from, point - from), normal) / twiceArea;
    return part < -gap * glm::length(to - from) ? -1.0 : std::max(0.0, part);
  };
  const glm::dvec3 parts(share(b, c), share(c, a), share(a, b));
  if (parts.x < 0.0 || parts.y < 0.0 || parts.z < 0.0)
  {
    return std::nullopt;
  }
  return glm::vec3(parts / (parts.x + parts.y + parts.z));
}

bool Scene::FindFront(const Ray& ray, Hit& hit) const
{
  const auto corner = [&](const Facet& facet, int c)
  { return glm::dvec3(this->VertexRecords[facet.vertices[c]].position); };
  const Facet& behind = this->FacetRecords[hit.facet];
  const glm::dvec3 point = double(hit.barycentric.x) * corner(behind, 0) +
    double(hit.barycentric.y) * corner(behind, 1) + double(hit.barycentric.z) * corner(behind, 2);
  const double near = double{ SheetGap } * this->Reach(point);
  const double gap = near + 2.0 * this->Rounding.Along(glm::dvec3(behind.normal), point);
  std::uint32_t chosen = NoFacet; // the first in the list, whatever the order of the search
  const auto look = [&](std::uint32_t f)
  {
    const Facet& facet = this->FacetRecords[f];
    if (f < chosen && glm::dot(ray.direction, facet.normal) < 0.0f &&
      glm::dot(behind.normal, facet.normal) < -SameSheet)
    {
      const auto there = Within(point, gap, corner(facet, 0), corner(facet, 1), corner(facet, 2));
      if (there)
      {
        chosen = f;
        hit.barycentric = *there;
        hit.part = NoPart;
        if (gap > near) // the other sheet may be farther off than rays start
        {
          hit.part = NoPartButLifted;
          hit.inPart = glm::vec3(static_cast<float>(gap));
        }
      }
    }
  };
  this->ForEachNear(glm::vec3(point), static_cast<float>(gap), look);
  hit.facet = chosen != NoFacet ? chosen : hit.facet;
  return chosen != NoFacet;
}

} // namespace PhotonTransport
