// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LightBounds.h"

#include "PhotonTransport/geometry/Pi.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Bounds of cosines that are less by rounding must not hide light.
constexpr double Rounding = 1e-5;

/// Cosines count so much at least, so that rounding does not decide among lights seen edge on.
constexpr double Least = 0.01;

constexpr double LeastSquare = std::numeric_limits<double>::min();

void JoinBoxes(const LightBounds& a, const LightBounds& b, LightBounds& both)
{
  const glm::dvec3 low = glm::min(a.centre - a.half, b.centre - b.half);
  const glm::dvec3 high = glm::max(a.centre + a.half, b.centre + b.half);
  both.centre = 0.5 * (low + high);
  both.half = (0.5 * (high - low)) * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
}

void JoinCones(const LightBounds& a, const LightBounds& b, LightBounds& both)
{
  const double spreadA = std::acos(a.cosSpread), spreadB = std::acos(b.cosSpread);
  const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
  const bool aHolds = between + spreadB <= spreadA;
  if (aHolds || between + spreadA <= spreadB)
  {
    const LightBounds& wider = aHolds ? a : b;
    both.axis = wider.axis;
    both.cosSpread = wider.cosSpread;
    both.sinSpread = wider.sinSpread;
    return;
  }
  const double spread = 0.5 * (spreadA + spreadB + between);
  const glm::dvec3 beside = b.axis - glm::dot(a.axis, b.axis) * a.axis;
  if (!(spread < Pi) || !(glm::length(beside) > 0.0))
  {
    return; // every way
  }
  const double turn = spread - spreadA;
  both.axis = glm::normalize(std::cos(turn) * a.axis + std::sin(turn) * glm::normalize(beside));
  both.cosSpread = std::cos(spread);
  both.sinSpread = std::sin(spread);
}

/// The cosine of an angle less another one, or 1 if the other one is larger.
double CosineOfRest(double cosine, double cosLess, double sinLess)
{
  return cosine >= cosLess
    ? 1.0
    : cosine * cosLess + std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * sinLess;
}

/// A box, and the ball around it, as they are seen from a point.
struct SeenBox
{
  glm::dvec3 way; ///< To the middle; of unit length if the point is outside of the ball.
  glm::dvec3 toMiddle;
  glm::dvec3 half;
  double squaredDistance;
  double squaredRadius;
  double distance;                 ///< To the nearest place of the box.
  double sine = 1.0, cosine = 0.0; ///< Of the angle from the ball's middle to its rim.

  SeenBox(const LightBounds& light, const glm::dvec3& point)
    : way(light.centre - point)
    , toMiddle(this->way)
    , half(light.half)
    , squaredDistance(glm::dot(this->way, this->way))
    , squaredRadius(glm::dot(this->half, this->half))
    , distance(glm::length(glm::max(glm::abs(this->way) - this->half, glm::dvec3(0.0))))
  {
    if (this->squaredDistance > this->squaredRadius * (1.0 + Rounding))
    {
      const double sine2 = this->squaredRadius / this->squaredDistance;
      this->sine = std::sqrt(sine2);
      this->cosine = std::sqrt(1.0 - sine2);
      this->way /= std::sqrt(this->squaredDistance);
    }
  }
  bool IsOutside() const { return this->cosine > 0.0; }
  /// The largest cosine of a direction to a place in the ball; 1 within it.
  double CosineToBall(const glm::dvec3& direction) const
  {
    return this->IsOutside()
      ? CosineOfRest(glm::dot(this->way, direction), this->cosine, this->sine)
      : 1.0;
  }
  /// A bound of the cosine of a direction to a place in the box: how far the box reaches along the
  /// direction, over the least distance.
  double CosineToBox(const glm::dvec3& direction) const
  {
    const double reach =
      glm::dot(this->toMiddle, direction) + glm::dot(this->half, glm::abs(direction));
    return reach < this->distance ? std::max(0.0, reach) / this->distance : 1.0;
  }
};

/// The largest cosine of a place to the normal of a point; 1 where there is none, and light counts
/// alike from all directions. The ball alone decides what is below the horizon: close to the box
/// rounding would.
double CosineAt(const SeenBox& box, const glm::dvec3& normal)
{
  return normal == glm::dvec3(0.0) ? 1.0
                                   : std::min(box.CosineToBall(normal), box.CosineToBox(normal));
}

/// The same of the point as the places face it.
double CosineAtLight(const SeenBox& box, const LightBounds& light)
{
  if (!(light.cosSpread > -1.0))
  {
    return 1.0;
  }
  const double cosine = std::min(box.CosineToBall(-light.axis), box.CosineToBox(-light.axis));
  return CosineOfRest(cosine, light.cosSpread, light.sinSpread);
}

} // namespace

LightBounds Joined(const LightBounds& a, const LightBounds& b)
{
  LightBounds both;
  JoinBoxes(a, b, both);
  JoinCones(a, b, both);
  both.flux = a.flux + b.flux;
  return both;
}

double Brightness(const LightBounds& light, const glm::dvec3& point, const glm::dvec3& normal)
{
  const SeenBox box(light, point);
  const double atPoint = CosineAt(box, normal);
  const double atLight = CosineAtLight(box, light);
  if (atPoint < -Rounding || atLight < -Rounding)
  {
    return 0.0;
  }
  return light.flux * std::max(Least, atPoint) * std::max(Least, atLight) /
    std::max({ box.squaredDistance, box.squaredRadius, LeastSquare });
}

double CosineBound(const LightBounds& light, const glm::dvec3& point, const glm::dvec3& normal)
{
  return std::max(Least, CosineAt(SeenBox(light, point), normal));
}

} // namespace PhotonTransport
