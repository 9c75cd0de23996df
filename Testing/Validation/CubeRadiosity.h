// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

/// The illuminance in a closed cube of equal matt walls with a point lamp in its middle, by
/// radiosity: the light at points, from patches of constant exitance by closed-form factors. All
/// quarters of all walls are alike. No random numbers, and nothing of the product.
class CubeRadiosity
{
public:
  /// @param half Of the cube's edge, m. @param flux lm
  CubeRadiosity(double half, double flux, double reflectance);

  /// lx on a wall, at [0, 1]^2 from its middle to its corner. What two divisions tell is
  /// extrapolated, as if errors fell with the square of the patches' size.
  double At(double u, double v) const;
  /// By how much the extrapolation changes it, lx.
  double ErrorAt(double u, double v) const;

private:
  /// The exitances of a quarter divided into so many patches along each edge, which are narrower
  /// towards the cube's edges. @return [i * patches + j]
  std::vector<double> Solve(std::size_t patches) const;
  double Direct(double u, double v) const;
  double Indirect(double u, double v, const std::vector<double>& exitance) const;
  /// [patch] Factors from a point to the patches of like exitance on all walls.
  std::vector<double> Factors(double u, double v, std::size_t patches) const;

  double Half, Flux, Reflectance;
  std::vector<double> Coarse, Fine;
};
