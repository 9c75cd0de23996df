// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// Directions whose density by solid angle is bilinear in polar angle and azimuth, on a grid. Two
/// numbers become two angles by exact inversion of the distribution, so that well spread numbers
/// give well spread directions.
class DirectionTable
{
public:
  /// @param polar Radians, rising, in [0, pi]. @param azimuth Radians, rising. At least two of
  /// each.
  /// @param values [azimuth][polar], finite, >= 0.
  DirectionTable(
    std::vector<double> polar, std::vector<double> azimuth, std::vector<double> values);

  /// Of the values over the solid angle of the grid.
  double Integral() const { return this->BandEnds.back(); }

  /// Of the values times the cosine of the polar angle, over the part up to pi/2.
  double CosineIntegral() const;

  /// Polar angle and azimuth, radians. Integral() must not be 0. @param u, v In [0, 1).
  glm::dvec2 Sample(double u, double v) const;

private:
  double PolarAt(double share, std::size_t& band) const;
  double Value(std::size_t polar, std::size_t azimuth) const
  {
    return this->Values[azimuth * this->Polar.size() + polar];
  }

  std::vector<double> Polar, Azimuth;
  std::vector<double> Values; ///< [azimuth][polar]
  /// Integral over azimuth up to each one, [polar][azimuth]; linear between the polar angles.
  std::vector<double> UpTo;
  std::vector<double> BandEnds; ///< Integral up to the end of each band between polar angles.
};

} // namespace PhotonTransport
