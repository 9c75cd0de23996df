// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/TriangleArea.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

double LargestComponent(const glm::dvec3& v)
{
  const glm::dvec3 size = glm::abs(v);
  return std::max({ size.x, size.y, size.z });
}

} // namespace

bool HasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double rounding)
{
  constexpr double Needle = 1.0 / 64.0; // a facet lower than this part of its length is no such one
  // Halves, in units of the longest edge: nothing overflows or vanishes.
  glm::dvec3 ab = 0.5 * b - 0.5 * a;
  glm::dvec3 ac = 0.5 * c - 0.5 * a;
  glm::dvec3 bc = 0.5 * c - 0.5 * b;
  const double unit =
    std::max({ LargestComponent(ab), LargestComponent(ac), LargestComponent(bc) });
  if (!(unit > 0.0))
  {
    return false;
  }
  ab /= unit;
  ac /= unit;
  bc /= unit;
  const double longest = std::max({ glm::length(ab), glm::length(ac), glm::length(bc) });
  const double height = glm::length(glm::cross(ab, ac)) / longest;
  const double farthest =
    std::max({ LargestComponent(a), LargestComponent(b), LargestComponent(c) });
  return height > std::min(rounding * (0.5 * farthest / unit), Needle * longest);
}

} // namespace PhotonTransport
