// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/LineLamp.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

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
    Frame(glm::normalize(normal))
      .ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

} // namespace PhotonTransport
