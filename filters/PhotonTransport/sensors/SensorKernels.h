// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sensors/Sensor.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace PhotonTransport
{

/// What is measured at a sensor, as places in a list. Each is an illuminance: the integral of the
/// luminance times a kernel, which says how much light from a direction counts. CIE S 017, "ILV:
/// International Lighting Vocabulary", has their definitions.
namespace Measure
{
constexpr std::size_t Own = 0;             ///< Of a surface across the sensor's normal: cos+.
constexpr std::size_t Horizontal = 1;      ///< Of a surface that faces up: cos+.
constexpr std::size_t Cylindrical = 2;     ///< Mean over all vertical surfaces: sin / pi.
constexpr std::size_t Hemispherical = 3;   ///< Mean over the upper half of a ball: (1 + cos) / 4.
constexpr std::size_t Spherical = 4;       ///< Mean over a ball: 1 / 4.
constexpr std::size_t Vertical = 5;        ///< Of surfaces that face each of the views.
constexpr std::size_t Semicylindrical = 9; ///< The half towards a view: (1 + cos azimuth) sin / pi.
constexpr std::size_t Number = 13;
}

template <class Value>
using Measured = std::array<Value, Measure::Number>;

/// The kernels of all measures in a direction. @param direction Unit, to where light comes from.
inline Measured<float> KernelsAt(
  const glm::dvec3& direction, const glm::dvec3& normal, const SensorDirections& directions)
{
  constexpr double PerPi = 0.31830988618379067;
  const auto above = [](double cosine) { return static_cast<float>(std::max(0.0, cosine)); };
  Measured<float> kernels;
  const double cosine = glm::dot(direction, directions.up);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  kernels[Measure::Own] = above(glm::dot(direction, normal));
  kernels[Measure::Horizontal] = above(cosine);
  kernels[Measure::Cylindrical] = static_cast<float>(PerPi * sine);
  kernels[Measure::Hemispherical] = above(0.25 * (1.0 + cosine));
  kernels[Measure::Spherical] = 0.25f;
  for (std::size_t v = 0; v < SensorDirections::Views; ++v)
  {
    const double towards = glm::dot(direction, directions.views[v]); // sin * cos(azimuth)
    kernels[Measure::Vertical + v] = above(towards);
    kernels[Measure::Semicylindrical + v] = above(PerPi * (sine + towards));
  }
  return kernels;
}

} // namespace PhotonTransport
