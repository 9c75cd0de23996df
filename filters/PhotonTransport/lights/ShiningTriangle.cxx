// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/ShiningTriangle.h"

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/lights/LambertPolygon.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// From farther than so many times the longest edge places are drawn by area.
constexpr double Far = 3.0;

/// Below this solid angle, which a triangle has from near by only where it is seen edge on, the
/// angles of the spherical triangle have lost too many digits.
constexpr double LeastSolidAngle = 1e-6;

/// The part of `a` that is perpendicular to the unit vector `b`, at unit length; or any such.
glm::dvec3 Beside(const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 rest = a - glm::dot(a, b) * b;
  const double length = glm::length(rest);
  return length > 0.0 ? rest / length : glm::dvec3(0.0);
}

/// A spherical triangle by the unit vectors to its corners.
class SphericalTriangle
{
public:
  SphericalTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    : A(a)
    , B(b)
    , C(c)
  {
    const double volume = std::fabs(glm::dot(a, glm::cross(b, c)));
    const double ab = glm::dot(a, b), bc = glm::dot(b, c), ca = glm::dot(c, a);
    // Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983.
    this->Area = 2.0 * std::atan2(volume, 1.0 + ab + bc + ca);
    this->Alpha = std::atan2(volume, bc - ab * ca); // the angle at A
    this->CosineC = ab;                             // of the edge opposite C
  }

  double SolidAngle() const { return this->Area; }

  /// Arvo 1995, the algorithm of its section 3.
  glm::dvec3 Direction(double u, double v) const
  {
    const double part = u * this->Area;
    const double s = std::sin(part - this->Alpha);
    const double t = std::cos(part - this->Alpha);
    const double sine = std::sin(this->Alpha), cosine = std::cos(this->Alpha);
    const double p = t - cosine;
    const double r = s + sine * this->CosineC;
    const double below = (r * s + p * t) * sine;
    const double q =
      below != 0.0 ? std::clamp(((r * t - p * s) * cosine - r) / below, -1.0, 1.0) : 1.0;
    const glm::dvec3 c = q * this->A + std::sqrt(1.0 - q * q) * Beside(this->C, this->A);
    const double z = std::clamp(1.0 - v * (1.0 - glm::dot(c, this->B)), -1.0, 1.0);
    return z * this->B + std::sqrt(1.0 - z * z) * Beside(c, this->B);
  }

private:
  glm::dvec3 A, B, C;
  double Area, Alpha, CosineC;
};

} // namespace

ShiningTriangle::Seen ShiningTriangle::From(const glm::dvec3& point, float a, float b) const
{
  const glm::dvec3 toCorner = this->corner - point;
  const double height = -glm::dot(toCorner, this->normal);
  const double area = 0.5 * glm::length(glm::cross(this->u, this->v));
  if (!(height > 0.0 && area > 0.0))
  {
    return {};
  }
  const glm::dvec3 toU = toCorner + this->u, toV = toCorner + this->v;
  const glm::dvec3 third = toU - toV;
  const double edge2 =
    std::max({ glm::dot(this->u, this->u), glm::dot(this->v, this->v), glm::dot(third, third) });
  const glm::dvec3 toMiddle = (toCorner + toU + toV) / 3.0;
  if (glm::dot(toMiddle, toMiddle) > Far * Far * edge2)
  {
    return this->ByArea(point, a, b);
  }
  const SphericalTriangle seen(glm::normalize(toCorner), glm::normalize(toU), glm::normalize(toV));
  if (!(seen.SolidAngle() > LeastSolidAngle))
  {
    return this->ByArea(point, a, b);
  }
  const glm::dvec3 direction = seen.Direction(double{ a }, double{ b });
  // Where the ray meets the plane (Moeller and Trumbore, "Fast, Minimum Storage Ray-Triangle
  // Intersection", 1997); rounding may put it beside the triangle.
  const glm::dvec3 across = glm::cross(direction, this->v);
  const double determinant = glm::dot(this->u, across);
  const double scale = determinant != 0.0 ? 1.0 / determinant : 0.0;
  const double x = std::clamp(-glm::dot(toCorner, across) * scale, 0.0, 1.0);
  const double y =
    std::clamp(-glm::dot(direction, glm::cross(toCorner, this->u)) * scale, 0.0, 1.0 - x);
  return { { x, y }, seen.SolidAngle() / (Pi * area), this->corner + x * this->u + y * this->v };
}

ShiningTriangle::Seen ShiningTriangle::ByArea(const glm::dvec3& point, float a, float b) const
{
  const glm::dvec2 share(UniformTriangle(a, b));
  const glm::dvec3 place = this->corner + share.x * this->u + share.y * this->v;
  const glm::dvec3 way = point - place;
  const double d2 = glm::dot(way, way);
  const double cosine = glm::dot(way, this->normal) / std::sqrt(d2);
  return { share, std::max(0.0, cosine) / (Pi * d2), place };
}

std::optional<double> ShiningTriangle::Unobstructed(
  const glm::dvec3& point, const glm::dvec3& facing) const
{
  const glm::dvec3 toCorner = this->corner - point;
  const double area = 0.5 * glm::length(glm::cross(this->u, this->v));
  if (!(glm::dot(toCorner, this->normal) < 0.0 && area > 0.0))
  {
    return 0.0;
  }
  constexpr double TooFar = 1e4; // sizes; from there on little is left of the formula's digits
  if (glm::length(toCorner) > TooFar * std::sqrt(area))
  {
    return std::nullopt;
  }
  const glm::dvec3 toU = toCorner + this->u, toV = toCorner + this->v;
  return ConfigurationFactor({ toCorner, toU, toV, toV }, facing) / area;
}

} // namespace PhotonTransport
