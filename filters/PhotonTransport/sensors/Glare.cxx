// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sensors/Glare.h"

#include "PhotonTransport/geometry/Pi.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

double PositionIndex(const glm::dvec3& direction, const glm::dvec3& view, const glm::dvec3& up)
{
  const double ahead = glm::dot(direction, view);
  if (!(ahead > 0.0))
  {
    return 0.0;
  }
  constexpr double Degrees = 180.0 / Pi;
  const double above = std::fabs(glm::dot(direction, up));
  const double aside = std::fabs(glm::dot(direction, glm::cross(view, up)));
  // From the vertical plane of the line of sight, and from the line of sight, degrees.
  const double tau = above + aside > 0.0 ? Degrees * std::atan2(aside, above) : 0.0;
  const double sigma = Degrees * std::atan2(std::hypot(above, aside), ahead);
  const double linear = 35.2 - 0.31889 * tau - 1.22 * std::exp(-2.0 * tau / 9.0);
  const double square = 21.0 + 0.26667 * tau - 0.002963 * tau * tau;
  return std::exp(1e-3 * linear * sigma + 1e-5 * square * sigma * sigma);
}

GlareRating RatingOf(const GlareSum& glare, double background, double backgroundError)
{
  constexpr double Most = 100.0;
  if (!(glare.sum > 0.0))
  {
    return {};
  }
  if (!(background > 0.0))
  {
    return { Most, 0.0 };
  }
  const double rating = 8.0 * std::log10(0.25 * Pi / background * glare.sum);
  const double relative =
    std::hypot(std::sqrt(glare.variance) / glare.sum, backgroundError / background);
  return { std::clamp(rating, 0.0, Most), 8.0 / std::log(10.0) * relative };
}

} // namespace PhotonTransport
