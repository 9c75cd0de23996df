// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/DoubleSheets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Planes are told apart by the point nearest to the origin, which does not depend on the side they
/// face, in cells of this size. Far more than rounding, so that few planes of a pair lie in two.
constexpr float CellsPerUnit = 1024.0f;

/// Cosine above which two normals count as one.
constexpr float SameSide = 0.999f;

struct Entry
{
  std::uint64_t cell;
  std::uint32_t facet;
  bool operator<(const Entry& other) const
  {
    return this->cell != other.cell ? this->cell < other.cell : this->facet < other.facet;
  }
};

std::uint64_t CellOf(const FacetPlane& plane, float shift)
{
  const glm::vec3 nearest = glm::dot(plane.point, plane.normal) * plane.normal;
  const glm::vec3 cell = glm::floor((nearest + 2.0f) * CellsPerUnit + shift); // within [0, 2^13)
  return (static_cast<std::uint64_t>(cell.x) << 40) | (static_cast<std::uint64_t>(cell.y) << 20) |
    static_cast<std::uint64_t>(cell.z);
}

/// Marks the facets of every cell that holds more than one direction.
void Mark(std::vector<std::uint8_t>& marked, const std::vector<FacetPlane>& planes, float shift)
{
  std::vector<Entry> entries;
  entries.reserve(planes.size());
  for (std::uint32_t f = 0; f < planes.size(); ++f)
  {
    entries.push_back({ CellOf(planes[f], shift), f });
  }
  std::sort(entries.begin(), entries.end());
  for (auto first = entries.begin(); first != entries.end();)
  {
    const auto last = std::find_if(
      first, entries.end(), [&](const Entry& entry) { return entry.cell != first->cell; });
    const glm::vec3& normal = planes[first->facet].normal;
    const bool alike = std::all_of(first, last,
      [&](const Entry& entry) { return glm::dot(planes[entry.facet].normal, normal) > SameSide; });
    for (; first != last; ++first)
    {
      marked[first->facet] |= !alike;
    }
  }
}

} // namespace

std::vector<std::uint8_t> FacetsOfDoubleSheets(const std::vector<FacetPlane>& planes)
{
  std::vector<std::uint8_t> marked(planes.size(), 0);
  // A pair that a border of the first grid divides is together in the second.
  Mark(marked, planes, 0.3f);
  Mark(marked, planes, 0.7f);
  const bool any = std::any_of(marked.begin(), marked.end(), [](std::uint8_t m) { return m != 0; });
  return any ? marked : std::vector<std::uint8_t>();
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
