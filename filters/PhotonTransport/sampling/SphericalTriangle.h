// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// A triangle on the unit sphere, and directions uniform over it by solid angle. J. Arvo,
/// "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995: well spread numbers give well
/// spread directions.
class SphericalTriangle
{
public:
  /// @param a, b, c Unit, no two of them opposite.
  SphericalTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    : A(a)
    , B(b)
    , TowardsC(Beside(c, a))
    , CosAB(glm::dot(a, b))
  {
    // A. van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983, equation 8.
    const double volume = std::fabs(glm::dot(a, glm::cross(b, c)));
    this->Angle = 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    const glm::dvec3 towardsB = Beside(b, a);
    this->CosAlpha = std::clamp(glm::dot(towardsB, this->TowardsC), -1.0, 1.0);
    this->SinAlpha = glm::length(glm::cross(towardsB, this->TowardsC));
  }

  /// Steradians, 0 to 2 pi.
  double SolidAngle() const { return this->Angle; }

  /// A unit vector with density 1 / SolidAngle(), which must be above 0. @param u, v In [0, 1).
  glm::dvec3 Sample(double u, double v) const
  {
    // s and t are sine and cosine of u * SolidAngle() - alpha, as in the paper.
    const double part = u * this->Angle;
    const double s = std::sin(part) * this->CosAlpha - std::cos(part) * this->SinAlpha;
    const double t = std::cos(part) * this->CosAlpha + std::sin(part) * this->SinAlpha;
    const double across = t - this->CosAlpha;              // u in the paper
    const double along = s + this->SinAlpha * this->CosAB; // v in the paper
    const double below = (along * s + across * t) * this->SinAlpha;
    const double q =
      below == 0.0 ? 1.0 : ((along * t - across * s) * this->CosAlpha - along) / below;
    const glm::dvec3 onSide = Turned(this->A, this->TowardsC, std::clamp(q, -1.0, 1.0));
    const double z = 1.0 - v * (1.0 - glm::dot(onSide, this->B));
    return Turned(this->B, Beside(onSide, this->B), std::clamp(z, -1.0, 1.0));
  }

private:
  /// The unit vector at right angles to another, on the side of a vector; any if there is none.
  static glm::dvec3 Beside(const glm::dvec3& vector, const glm::dvec3& axis)
  {
    const glm::dvec3 beside = vector - glm::dot(vector, axis) * axis;
    const double length = glm::length(beside);
    return length > 0.0 ? beside / length : glm::dvec3(0.0);
  }

  static glm::dvec3 Turned(const glm::dvec3& axis, const glm::dvec3& beside, double cosine)
  {
    return cosine * axis + std::sqrt((1.0 - cosine) * (1.0 + cosine)) * beside;
  }

  glm::dvec3 A, B;
  glm::dvec3 TowardsC; ///< From A, at right angles to it.
  double CosAB;
  double CosAlpha, SinAlpha; ///< Of the angle at A.
  double Angle;
};

} // namespace PhotonTransport
