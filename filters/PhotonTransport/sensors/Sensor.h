// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// A point with a normal that receives light and is no part of the scene.
struct Sensor
{
  glm::dvec3 position; ///< In the data's length unit, finite.
  glm::dvec3 normal;   ///< Unit.
};

/// Directions that all sensors have in common; unit vectors.
struct SensorDirections
{
  static constexpr std::size_t Views = 4;

  glm::dvec3 up;
  /// Horizontal, at right angles to each other, counter-clockwise as seen from above.
  std::array<glm::dvec3, Views> views;

  /// @param upwards Any length but 0. @param azimuth Of the first view, radians, counter-clockwise
  /// from the horizontal part of +x, or of +y where up lies along x. Throws InvalidInput for an
  /// `upwards` that is no direction, or an azimuth that is not finite.
  static SensorDirections From(const glm::dvec3& upwards, double azimuth);
};

} // namespace PhotonTransport
