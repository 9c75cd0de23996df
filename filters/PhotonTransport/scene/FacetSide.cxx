// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/FacetSide.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

glm::dvec3 UsableNormal(const glm::dvec3& normal)
{
  const double largest =
    std::max({ std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z) });
  // max() may drop a NaN, the sum does not.
  if (!(largest > 0.0) || !std::isfinite(normal.x + normal.y + normal.z))
  {
    return glm::dvec3(0.0);
  }
  return glm::normalize(normal / largest); // no overflow at 1e200, no underflow at 1e-200
}

FacetSide SideOf(const glm::dvec3& areaVector, const std::array<glm::dvec3, 3>& normals)
{
  return SideByUsableNormals(
    areaVector, { UsableNormal(normals[0]), UsableNormal(normals[1]), UsableNormal(normals[2]) });
}

FacetSide SideByUsableNormals(
  const glm::dvec3& areaVector, const std::array<glm::dvec3, 3>& normals)
{
  glm::dvec3 front(0.0);
  double usable = 0.0;
  for (const glm::dvec3& normal : normals)
  {
    front += normal;
    usable += normal == glm::dvec3(0.0) ? 0.0 : 1.0;
  }
  const double height = glm::dot(front, UsableNormal(areaVector));
  const bool undecided = usable > 0.0 && std::fabs(height) <= InPlane * usable;
  return { !undecided && height < 0.0, undecided };
}

} // namespace PhotonTransport
