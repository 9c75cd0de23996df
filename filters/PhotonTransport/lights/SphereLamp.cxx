// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/SphereLamp.h"

#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

void SphereLamp::Move(const Similarity& motion)
{
  this->centre = motion.Point(this->centre);
  this->radius *= motion.scale;
}

Prepared<SphereEmitter> SphereLamp::Prepare(const Scene& scene) const
{
  return { { {}, ClearPosition(this->centre, scene),
             CheckedLength(this->radius, scene, "lamp radius") },
    CheckedFlux(this->flux) };
}

Ray SphereEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::vec3 normal = glm::normalize(UniformSphereAbove(sample.OnDisk(0)));
  return RayFrom(this->centre + this->radius * glm::dvec3(normal),
    Frame(normal).ToWorld(CosineHemisphereAbove(sample.OnDisk(1))));
}

/// Places have even density by solid angle in the cone that the ball fills. Shirley, Wang and
/// Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", 1996, section 3.2.2.
Incidence SphereEmitter::Arriving(const glm::dvec3& point, float u, float v) const
{
  const glm::dvec3 way = this->centre - point;
  const double d = glm::length(way);
  if (!(d > this->radius && d > 0.0))
  {
    return {}; // photons leave outwards
  }
  const double edgeSine = this->radius / d;
  const double edgeCosine = std::sqrt((1.0 - edgeSine) * (1.0 + edgeSine));
  const glm::dvec2 p(ConcentricDisk(u, v));
  const double share = std::min(1.0, p.x * p.x + p.y * p.y);
  // 1 - cos of the angle to the axis; the solid angle is 2 pi (1 - cos) at the edge.
  const double whole = edgeSine * edgeSine / (1.0 + edgeCosine);
  const double part = share * whole;
  const double cosine = 1.0 - part;
  const double sine = std::sqrt(part * (2.0 - part));
  const double stretch = share > 0.0 ? sine / std::sqrt(share) : 0.0;
  const double nearest = std::max(0.0, (edgeSine - sine) * (edgeSine + sine));
  const double distance = d * (cosine - std::sqrt(nearest));
  const glm::dvec3 axis = way / d;
  const Frame frame = FrameOf(axis);
  const glm::dvec3 direction =
    cosine * axis + stretch * (p.x * glm::dvec3(frame.tangent) + p.y * glm::dvec3(frame.bitangent));
  // Luminance 1 / (4 pi^2 radius^2) times 2 pi (1 - cos), with the radius cancelled.
  return { point, point + distance * direction, 1.0 / (2.0 * Pi * d * d * (1.0 + edgeCosine)) };
}

/// As long as all of the ball stands above the horizon it gives what a point in its middle gives.
std::optional<double> SphereEmitter::Unobstructed(
  const glm::dvec3& point, const glm::dvec3& normal) const
{
  const glm::dvec3 way = this->centre - point;
  const double d2 = glm::dot(way, way);
  const double height = glm::dot(way, normal);
  if (!(d2 > this->radius * this->radius))
  {
    return 0.0;
  }
  return height > this->radius ? std::optional(height / (4.0 * Pi * d2 * std::sqrt(d2)))
                               : std::nullopt;
}

} // namespace PhotonTransport
