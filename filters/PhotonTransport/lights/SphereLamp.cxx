// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/SphereLamp.h"

#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

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
  const glm::vec3 normal = glm::normalize(UniformSphere(sample.Emission(0), sample.Emission(1)));
  return RayFrom(this->centre + this->radius * glm::dvec3(normal),
    Frame(normal).ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

} // namespace PhotonTransport
