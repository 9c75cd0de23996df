// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/SphericalRectangle.h"

#include "PhotonTransport/geometry/Pi.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Between two vectors; unlike the arc cosine exact for angles near 0 and pi.
double AngleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

SphericalRectangle::SphericalRectangle(const glm::dvec3& corner, const glm::dvec2& size)
  : X0(corner.x)
  , X1(corner.x + size.x)
  , Y0(corner.y)
  , Y1(corner.y + size.y)
  , Z(-std::fabs(corner.z))
{
  // Normals of the planes through the point and the edges, in turn around the rectangle.
  const glm::dvec3 n0 = glm::normalize(glm::dvec3(0.0, this->Z, -this->Y0));
  const glm::dvec3 n1 = glm::normalize(glm::dvec3(-this->Z, 0.0, this->X1));
  const glm::dvec3 n2 = glm::normalize(glm::dvec3(0.0, -this->Z, this->Y1));
  const glm::dvec3 n3 = glm::normalize(glm::dvec3(this->Z, 0.0, -this->X0));
  const double g0 = AngleBetween(-n0, n1);
  const double g1 = AngleBetween(-n1, n2);
  const double g2 = AngleBetween(-n2, n3);
  const double g3 = AngleBetween(-n3, n0);
  this->B0 = n0.z;
  this->B1 = n2.z;
  this->K = 2.0 * Pi - g2 - g3;
  this->Angle = std::max(0.0, g0 + g1 - this->K);
}

glm::dvec2 SphericalRectangle::Place(double u, double v) const
{
  // Section 4 of the paper: first x from the share of the solid angle, then y.
  const double angle = u * this->Angle + this->K;
  const double f = (std::cos(angle) * this->B0 - this->B1) / std::sin(angle);
  const double c =
    std::clamp(std::copysign(1.0 / std::sqrt(f * f + this->B0 * this->B0), f), -1.0, 1.0);
  double x = -(c * this->Z) / std::sqrt(std::max(0.0, 1.0 - c * c));
  x = x > this->X0 ? std::min(x, this->X1) : this->X0; // also where it is no number
  const double d2 = x * x + this->Z * this->Z;
  const double h0 = this->Y0 / std::sqrt(d2 + this->Y0 * this->Y0);
  const double h1 = this->Y1 / std::sqrt(d2 + this->Y1 * this->Y1);
  const double h = h0 + v * (h1 - h0);
  const double rest = 1.0 - h * h;
  const double y = rest > 1e-12 ? h * std::sqrt(d2 / rest) : this->Y1;
  return { x, std::clamp(y, this->Y0, this->Y1) };
}

} // namespace PhotonTransport
