// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/DoubleSheets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

std::vector<std::uint8_t> FacetsOfDoubleSheets(
  const std::vector<FacetPlane>& planes, const std::vector<PlaneMember>& groups)
{
  std::vector<std::uint8_t> marked;
  ForEachGroup(groups,
    [&](const PlaneMember* first, const PlaneMember* last)
    {
      const glm::vec3& normal = planes[first->facet].normal;
      const bool alike = std::all_of(first, last,
        [&](const PlaneMember& member)
        { return glm::dot(planes[member.facet].normal, normal) > SameSheet; });
      if (!alike)
      {
        marked.resize(planes.size(), 0);
        std::for_each(first, last, [&](const PlaneMember& member) { marked[member.facet] = 1; });
      }
    });
  return marked;
}

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

} // namespace PhotonTransport
