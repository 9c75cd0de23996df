// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/FluxTable.h"
#include "PhotonTransport/lights/IntervalSearch.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Directions whose density by solid angle is bilinear in polar angle and azimuth between the
/// points of a grid. Two numbers become two angles by inversion of the distribution, so that well
/// spread numbers give well spread directions.
class DirectionTable
{
public:
  /// @param polar Radians, rising, in [0, pi]. @param azimuth Radians, rising. At least two of
  /// each.
  /// @param values [azimuth][polar], finite, >= 0.
  DirectionTable(
    std::vector<double> polar, std::vector<double> azimuth, std::vector<double> values);

  /// The integral of the values over the solid angle of the grid.
  double Integral() const { return this->Whole; }

  /// The integral of the values times the cosine of the polar angle, over the part up to pi/2.
  double CosineIntegral() const;

  /// Polar angle and azimuth, radians. Integral() must not be 0. @param u, v In [0, 1).
  glm::dvec2 Sample(double u, double v) const;

  /// The value in a direction; 0 beyond the grid. @param angles Polar angle and azimuth, radians;
  /// the azimuth may be off by whole turns.
  double Value(const glm::dvec2& angles) const;

private:
  /// One polar angle of the grid.
  struct Ring
  {
    double angle, sine, cosine;
    double integral; ///< Of the values over azimuth.
  };
  /// One point of the grid.
  struct Node
  {
    double value;
    double upTo; ///< Integral of the ring's values up to this azimuth.
  };

  void AddUpRing(std::size_t ring);
  void FindFirstOfParts(std::size_t ring);
  double PolarAt(double share, std::size_t& band) const;
  double AzimuthAt(std::size_t band, double below, double share) const;

  IntervalSearch PolarSearch, AzimuthSearch; ///< For Value.
  std::vector<double> Azimuth;
  std::vector<Ring> Rings;
  std::vector<Node> Nodes; ///< [ring][azimuth]
  FluxTable Bands;         ///< Chooses a band, which lies between two rings.
  double Whole = 0.0;
  /// [ring][part] The first interval of azimuth that reaches into a part of the ring's integral,
  /// which has as many equal parts as there are intervals. See FluxTable.
  std::vector<std::uint32_t> FirstOfPart;
};

/// The unit vector to what DirectionTable::Sample gives. @param azimuth0, azimuth90, pole
/// Orthonormal.
inline glm::vec3 UnitDirection(const glm::dvec2& angles, const glm::dvec3& azimuth0,
  const glm::dvec3& azimuth90, const glm::dvec3& pole)
{
  const double sine = std::sin(angles.x);
  return glm::normalize(glm::vec3(std::cos(angles.x) * pole +
    sine * (std::cos(angles.y) * azimuth0 + std::sin(angles.y) * azimuth90)));
}

/// Polar angle and azimuth of a direction of any length but 0, radians; the inverse of
/// UnitDirection.
inline glm::dvec2 AnglesOf(const glm::dvec3& direction, const glm::dvec3& azimuth0,
  const glm::dvec3& azimuth90, const glm::dvec3& pole)
{
  const double x = glm::dot(direction, azimuth0);
  const double y = glm::dot(direction, azimuth90);
  return { std::atan2(std::hypot(x, y), glm::dot(direction, pole)), std::atan2(y, x) };
}

} // namespace PhotonTransport
