// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sensors/Sensor.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace PhotonTransport
{

SensorDirections SensorDirections::From(const glm::dvec3& upwards, double azimuth)
{
  const double length = glm::length(upwards);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0,
      "the direction up is no direction: it must be finite and not zero");
  }
  if (!std::isfinite(azimuth))
  {
    throw InvalidInput(
      InvalidInput::Where::TraceSettings, 0, "the azimuth of the first view is not finite");
  }
  SensorDirections directions;
  directions.up = upwards / length;
  constexpr double AlmostUp = 1e-6;
  glm::dvec3 ahead = glm::dvec3(1.0, 0.0, 0.0) - directions.up.x * directions.up;
  if (!(glm::length(ahead) > AlmostUp))
  {
    ahead = glm::dvec3(0.0, 1.0, 0.0) - directions.up.y * directions.up;
  }
  ahead = glm::normalize(ahead);
  const glm::dvec3 left = glm::cross(directions.up, ahead);
  const glm::dvec3 first = std::cos(azimuth) * ahead + std::sin(azimuth) * left;
  const glm::dvec3 second = glm::cross(directions.up, first);
  directions.views = { first, second, -first, -second };
  return directions;
}

} // namespace PhotonTransport
