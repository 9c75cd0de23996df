// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sensors/GridArea.h"
#include "PhotonTransport/sensors/Sensor.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How a grid of sensors lies over an area; lengths in metres.
struct GridSettings
{
  double height = 0.75;       ///< Above the area, finite.
  double margin = 0.5;        ///< Along its outline without sensors, >= 0.
  double spacing = 0.0;       ///< About; 0: by EN 12464-1, see GridSpacing.
  double metresPerUnit = 1.0; ///< Of the data's lengths.

  static constexpr std::size_t MostSensors = 1000000;
};

/// Sensors in the middles of the cells of a rectangle, those outside of the area left out.
struct SensorGrid
{
  std::vector<Sensor> sensors;                    ///< They face up.
  std::array<std::size_t, 2> cells{};             ///< Along both sides of the rectangle.
  std::vector<std::array<std::size_t, 2>> cellOf; ///< [sensor]
  double cellArea = 0.0;                          ///< m^2
};

/// The spacing of a grid over a rectangle by EN 12464-1:2011, 4.4: p = 0.2 * 5^lg(d), at most 10 m,
/// where d is the longer side, or the shorter one where the longer is twice as long or more.
/// @return m
double GridSpacing(double length, double width);

/// Numbers of cells along the sides of a rectangle of so many metres: the nearest whole number of
/// d / p, and along the other side as many as make the cells nearly square.
/// @param spacing m; 0: GridSpacing.
std::array<std::size_t, 2> GridCells(double length, double width, double spacing);

/// The bottom of the box with these corners.
std::vector<AreaTriangle> BottomOfBox(
  const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& up);

/// A grid over the horizontal ones (up to 5 degrees) of some triangles; where they lie above each
/// other the lowest counts. It runs along the longest edge of their outline, and d and its cells
/// are those of the rectangle around them without the margin. Throws InvalidInput for settings out
/// of range, if no triangle is horizontal, or if the margin leaves nothing.
SensorGrid GridOver(const std::vector<AreaTriangle>& area, const SensorDirections& directions,
  const GridSettings& settings);

} // namespace PhotonTransport
