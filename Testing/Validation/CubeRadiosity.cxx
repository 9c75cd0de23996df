// SPDX-License-Identifier: BSD-3-Clause
#include "CubeRadiosity.h"

#include "References.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr std::size_t CoarsePatches = 12, FinePatches = 24;

/// A point on an edge lies in two walls, and its factor to the other one is that from just beside.
constexpr double BesideEdges = 1e-6;

/// Where patch i begins in [0, 1]; they are narrower towards 1, where the light varies most.
double Begin(std::size_t i, std::size_t patches)
{
  const double left = 1.0 - static_cast<double>(i) / static_cast<double>(patches);
  return 1.0 - left * left * left;
}

/// Of the point (u, v) on the wall z = -1 with the normal +z to a patch of another wall: the wall
/// across `axis` on side `sign`.
double FactorTo(
  double u, double v, int axis, double sign, const double (&a)[2], const double (&b)[2])
{
  const auto corner = [&](double s, double t)
  {
    glm::dvec3 point;
    point[axis] = sign;
    point[(axis + 1) % 3] = s;
    point[(axis + 2) % 3] = t;
    return point;
  };
  return References::ConfigurationFactor({ u, v, -1.0 }, { 0, 0, 1 },
    { corner(a[0], b[0]), corner(a[1], b[0]), corner(a[1], b[1]), corner(a[0], b[1]) });
}

} // namespace

CubeRadiosity::CubeRadiosity(double half, double flux, double reflectance)
  : Half(half)
  , Flux(flux)
  , Reflectance(reflectance)
  , Coarse(Solve(CoarsePatches))
  , Fine(Solve(FinePatches))
{
}

double CubeRadiosity::Direct(double u, double v) const
{
  // E = I cos / d^2, with d in halves of the edge.
  return this->Flux / (4.0 * References::Pi * this->Half * this->Half) /
    std::pow(1.0 + u * u + v * v, 1.5);
}

std::vector<double> CubeRadiosity::Factors(double u, double v, std::size_t patches) const
{
  u = std::min(u, 1.0 - BesideEdges);
  v = std::min(v, 1.0 - BesideEdges);
  constexpr struct
  {
    int axis;
    double sign;
  } Walls[] = { { 2, 1.0 }, { 0, 1.0 }, { 0, -1.0 }, { 1, 1.0 }, { 1, -1.0 } };
  std::vector<double> factors(patches * patches, 0.0);
  for (std::size_t i = 0; i < patches; ++i)
  {
    const double a[2] = { Begin(i, patches), Begin(i + 1, patches) };
    for (std::size_t j = 0; j < patches; ++j)
    {
      const double b[2] = { Begin(j, patches), Begin(j + 1, patches) };
      for (const auto& wall : Walls)
      {
        for (int quarter = 0; quarter < 4; ++quarter)
        {
          const double s = quarter % 2 == 0 ? 1.0 : -1.0;
          const double t = quarter < 2 ? 1.0 : -1.0;
          factors[i * patches + j] +=
            FactorTo(u, v, wall.axis, wall.sign, { s * a[0], s * a[1] }, { t * b[0], t * b[1] });
        }
      }
    }
  }
  return factors;
}

std::vector<double> CubeRadiosity::Solve(std::size_t patches) const
{
  std::vector<std::vector<double>> factors;
  std::vector<double> direct, exitance(patches * patches, 0.0);
  const auto middle = [&](std::size_t i)
  { return 0.5 * (Begin(i, patches) + Begin(i + 1, patches)); };
  for (std::size_t i = 0; i < patches; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j) // the other half is alike
    {
      factors.push_back(this->Factors(middle(i), middle(j), patches));
      direct.push_back(this->Direct(middle(i), middle(j)));
    }
  }
  constexpr int Sweeps = 100; // each takes a third of the error at least
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    std::size_t row = 0;
    for (std::size_t i = 0; i < patches; ++i)
    {
      for (std::size_t j = 0; j <= i; ++j, ++row)
      {
        double lux = direct[row];
        for (std::size_t k = 0; k < exitance.size(); ++k)
        {
          lux += factors[row][k] * exitance[k];
        }
        exitance[i * patches + j] = exitance[j * patches + i] = this->Reflectance * lux;
      }
    }
  }
  return exitance;
}

double CubeRadiosity::Indirect(double u, double v, const std::vector<double>& exitance) const
{
  const auto patches = static_cast<std::size_t>(std::lround(std::sqrt(exitance.size())));
  const std::vector<double> factors = this->Factors(u, v, patches);
  double lux = 0.0;
  for (std::size_t k = 0; k < exitance.size(); ++k)
  {
    lux += factors[k] * exitance[k];
  }
  return lux;
}

double CubeRadiosity::ErrorAt(double u, double v) const
{
  const double change = this->Indirect(u, v, this->Fine) - this->Indirect(u, v, this->Coarse);
  return std::fabs(change) / 3.0;
}

double CubeRadiosity::At(double u, double v) const
{
  const double fine = this->Indirect(u, v, this->Fine);
  const double change = fine - this->Indirect(u, v, this->Coarse);
  return this->Direct(u, v) + fine + change / 3.0; // Richardson, second order
}
