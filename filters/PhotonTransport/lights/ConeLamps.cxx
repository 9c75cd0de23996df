// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/ConeLamps.h"

#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <cmath>

namespace PhotonTransport
{

void LambertianPointLamp::Move(const Similarity& motion)
{
  this->position = motion.Point(this->position);
  this->direction = motion.Direction(this->direction);
}

void SpotLamp::Move(const Similarity& motion)
{
  this->position = motion.Point(this->position);
  this->direction = motion.Direction(this->direction);
}

Prepared<ConeEmitter> PointLamp::Prepare(const Scene& scene) const
{
  return { { {}, ClearPosition(this->position, scene), FrameOf({ 0.0, 0.0, 1.0 }), 0.0f, -1.0f },
    CheckedFlux(this->flux) };
}

Prepared<ConeEmitter> LambertianPointLamp::Prepare(const Scene& scene) const
{
  const glm::dvec3 aim = CheckedDirection(this->direction);
  return { { {}, ClearPosition(this->position, scene, aim), FrameOf(aim), 1.0f, 0.0f },
    CheckedFlux(this->flux) };
}

Prepared<ConeEmitter> SpotLamp::Prepare(const Scene& scene) const
{
  const double widest = this->exponent > 0.0 ? 0.5 * Pi : Pi;
  if (!(this->halfAngle > 0.0 && this->halfAngle <= widest * (1.0 + 1e-12)))
  {
    RefuseLamp("spot half-angle " + std::to_string(this->halfAngle * 180.0 / Pi) +
      " degrees is outside (0, " + std::to_string(widest * 180.0 / Pi) +
      "] (an exponent above 0 ends at 90)");
  }
  CheckedAmount(this->exponent, "spot exponent");
  const auto cosMax = static_cast<float>(std::cos(this->halfAngle));
  const glm::dvec3 aim = CheckedDirection(this->direction);
  return { { {}, ClearPosition(this->position, scene, aim), FrameOf(aim),
             static_cast<float>(this->exponent),
             this->exponent > 0.0 ? std::max(0.0f, cosMax) : cosMax },
    CheckedFlux(this->flux) };
}

Ray ConeEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  return RayFrom(this->position,
    this->axis.ToWorld(PowerCosineConeAbove(sample.OnDisk(0), this->exponent, this->cosMax)));
}

Incidence ConeEmitter::Arriving(const glm::dvec3& point, float, float) const
{
  const glm::dvec3 way = point - this->position;
  const double d2 = glm::dot(way, way);
  const double cosine = glm::dot(way, glm::dvec3(this->axis.normal)) / std::sqrt(d2);
  const double edge = this->cosMax;
  if (!(cosine >= edge && d2 > 0.0))
  {
    return {};
  }
  // The density of PowerCosineCone. Only a cone beyond a right angle has a negative edge, and it
  // has no exponent.
  const double n = this->exponent;
  const double whole = 2.0 * Pi * (n == 0.0 ? 1.0 - edge : 1.0 - std::pow(edge, n + 1.0));
  const double intensity = (n + 1.0) * (n == 0.0 ? 1.0 : std::pow(cosine, n)) / whole;
  return { point, this->position, intensity / d2 };
}

} // namespace PhotonTransport
