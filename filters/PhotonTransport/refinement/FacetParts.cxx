// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/FacetParts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace PhotonTransport
{
namespace
{

/// Barycentric coordinates with 20 binary places are exact in a float, and so are the sums of their
/// halves. A shorter edge is not halved.
constexpr float LeastEdge = 0x1p-19f;

float Extent(const glm::vec3& p, const glm::vec3& q)
{
  return std::max({ std::fabs(p.x - q.x), std::fabs(p.y - q.y), std::fabs(p.z - q.z) });
}

} // namespace

glm::vec3 PositionOf(const glm::vec3& barycentric, const std::array<glm::vec3, 3>& corners)
{
  return glm::vec3(double{ barycentric.x } * glm::dvec3(corners[0]) +
    double{ barycentric.y } * glm::dvec3(corners[1]) +
    double{ barycentric.z } * glm::dvec3(corners[2]));
}

void AppendParts(std::uint32_t facet, const std::array<glm::vec3, 3>& corners,
  const HalvesEdge& halves, std::vector<FacetPart>& parts)
{
  const auto halvesBetween = [&](const glm::vec3& one, const glm::vec3& other)
  {
    // The order of the end points must not matter.
    const auto key = [](const glm::vec3& p) { return std::make_tuple(p.x, p.y, p.z); };
    const glm::vec3 p = PositionOf(one, corners), q = PositionOf(other, corners);
    return Extent(one, other) >= LeastEdge && (key(p) < key(q) ? halves(p, q) : halves(q, p));
  };
  const auto keep = [&](const FacetTriangle& part)
  {
    if (part != WholeFacet)
    {
      parts.push_back({ { facet, part },
        { PositionOf(part[0], corners), PositionOf(part[1], corners),
          PositionOf(part[2], corners) } });
    }
  };
  Subdivide(WholeFacet, halvesBetween, keep);
}

} // namespace PhotonTransport
