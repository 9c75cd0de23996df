// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/LineLamp.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

void LineLamp::Move(const Similarity& motion)
{
  this->centre = motion.Point(this->centre);
  this->axis = motion.Direction(this->axis);
  this->length *= motion.scale;
}

Prepared<LineEmitter> LineLamp::Prepare(const Scene& scene) const
{
  const glm::dvec3 along = CheckedDirection(this->axis, "lamp axis");
  const double inScene = CheckedLength(this->length, scene, "lamp length");
  LineEmitter tube{ {}, CheckedPosition(this->centre, scene), 0.5 * inScene * along,
    FrameOf(along) };
  tube.centre += WayClearOfFacets(scene,
    { tube.centre, tube.centre - tube.halfAxis, tube.centre + tube.halfAxis,
      tube.centre - 0.5 * tube.halfAxis, tube.centre + 0.5 * tube.halfAxis },
    glm::dvec3(0.0));
  return { tube, CheckedFlux(this->flux) };
}

Ray LineEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const double along = 2.0 * double{ sample.Emission(0) } - 1.0;
  const float azimuth = static_cast<float>(2.0 * Pi) * sample.Emission(1);
  const glm::vec3 normal = this->frame.ToWorld({ std::cos(azimuth), std::sin(azimuth), 0.0f });
  return RayFrom(this->centre + along * this->halfAxis,
    Frame(glm::normalize(normal)).ToWorld(CosineHemisphereAbove(sample.OnDisk(1))));
}

Incidence LineEmitter::Arriving(const glm::dvec3& point, float u, float) const
{
  // An element at distance r has an intensity of sin(theta) / pi^2 for 1 lm, where theta is its
  // angle to the axis, and so gives sin(theta) / (pi r)^2. With D the distance from the axis and
  // phi = atan(t / D) of the place t along it that is cos^3(phi) / (pi D)^2, and all of it is the
  // integral of cos(phi) dphi / (pi^2 D): places with an even density in sin(phi) bring the same.
  const glm::dvec3 axis(this->frame.normal);
  const double half = glm::length(this->halfAxis);
  const glm::dvec3 way = this->centre - point;
  const double along = glm::dot(way, axis);
  const double distance = glm::length(way - along * axis);
  const double first = along - half, last = along + half;
  if (!(distance > 0.0))
  {
    return {}; // nothing shines along the axis
  }
  constexpr double Short = 1e-4; // a tube so much shorter than its distance is even all along
  if (half <= Short * glm::length(way))
  {
    const double t = first + 2.0 * double{ u } * half;
    const double r2 = t * t + distance * distance;
    return { point, this->centre + (t - along) * axis, distance / (std::sqrt(r2) * r2 * Pi * Pi) };
  }
  const double from = first / std::hypot(first, distance);
  const double to = last / std::hypot(last, distance);
  const double sine = from + double{ u } * (to - from);
  const double t = std::clamp(
    distance * sine / std::sqrt(std::max(1e-300, (1.0 - sine) * (1.0 + sine))), first, last);
  return { point, this->centre + (t - along) * axis,
    (to - from) / (Pi * Pi * 2.0 * half * distance) };
}

std::optional<double> LineEmitter::Unobstructed(
  const glm::dvec3& point, const glm::dvec3& normal) const
{
  // With D, t and r as above and the normal's parts towards the foot on the axis, nD, and along the
  // axis, nA, the integral of D (nD D + nA t) / r^4 dt over what is above the horizon.
  const glm::dvec3 axis(this->frame.normal);
  const double half = glm::length(this->halfAxis);
  const glm::dvec3 way = this->centre - point;
  const double along = glm::dot(way, axis);
  const glm::dvec3 toFoot = way - along * axis;
  const double distance = glm::length(toFoot);
  constexpr double Far = 1e4; // lengths; from there on little is left of the formula's digits
  if (!(distance > 0.0) || !(glm::length(way) < Far * half))
  {
    return std::nullopt;
  }
  const double nD = glm::dot(normal, toFoot) / distance;
  const double nA = glm::dot(normal, axis);
  double first = along - half, last = along + half;
  const double horizon = -nD * distance / nA; // where nD D + nA t is 0
  (nA > 0.0 ? first : last) = nA > 0.0 ? std::max(first, horizon)
    : nA < 0.0                         ? std::min(last, horizon)
                                       : last;
  if (!(last > first) || (nA == 0.0 && !(nD > 0.0)))
  {
    return 0.0;
  }
  const auto primitive = [&](double t)
  {
    const double r2 = t * t + distance * distance;
    return 0.5 * (nD * (t / r2 + std::atan2(t, distance) / distance) - nA * distance / r2);
  };
  return std::max(0.0, primitive(last) - primitive(first)) / (Pi * Pi * 2.0 * half);
}

} // namespace PhotonTransport
