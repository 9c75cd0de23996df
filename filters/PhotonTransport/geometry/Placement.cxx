// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/Placement.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PhotonTransport
{

Placement FitPlacement(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::uvec3& facet : facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      low = glm::min(low, points[facet[corner]]);
      high = glm::max(high, points[facet[corner]]);
    }
  }

  Placement placement;
  // Halves first: the sum of two huge coordinates could overflow.
  placement.centre = 0.5 * low + 0.5 * high;
  const glm::dvec3 half = 0.5 * high - 0.5 * low;
  const double extent = std::max({ half.x, half.y, half.z });
  if (extent > 0.0)
  {
    int exponent = 0;
    const double mantissa = std::frexp(extent, &exponent); // in [0.5, 1)
    placement.scale = std::ldexp(1.0, mantissa > 0.5 ? -exponent : 1 - exponent);
  }
  return placement;
}

} // namespace PhotonTransport
