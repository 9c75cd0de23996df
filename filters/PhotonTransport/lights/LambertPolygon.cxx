// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/LambertPolygon.h"

#include "PhotonTransport/geometry/Pi.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>

namespace PhotonTransport
{
namespace
{

/// The part of a polygon above the horizon, which has one corner more at most.
struct Clipped
{
  std::array<glm::dvec3, 5> corners;
  std::size_t count = 0;

  Clipped(const std::array<glm::dvec3, 4>& polygon, const glm::dvec3& normal)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double above = glm::dot(a, normal), next = glm::dot(b, normal);
      if (above >= 0.0)
      {
        this->corners[this->count++] = a;
      }
      if ((above > 0.0 && next < 0.0) || (above < 0.0 && next > 0.0))
      {
        this->corners[this->count++] = a + (b - a) * (above / (above - next));
      }
    }
  }
};

} // namespace

double ConfigurationFactor(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& normal)
{
  const Clipped seen(corners, normal);
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.count; ++i)
  {
    // The angle that an edge subtends times the cosine to the plane through it and the point.
    const glm::dvec3 &a = seen.corners[i], &b = seen.corners[(i + 1) % seen.count];
    const glm::dvec3 across = glm::cross(a, b);
    const double length = glm::length(across);
    if (length > 0.0)
    {
      sum += std::atan2(length, glm::dot(a, b)) * glm::dot(across, normal) / length;
    }
  }
  return std::fabs(sum) / (2.0 * Pi);
}

} // namespace PhotonTransport
