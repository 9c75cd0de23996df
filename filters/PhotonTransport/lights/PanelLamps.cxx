// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/PanelLamps.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Moves a panel clear of facets that it touches with its centre or rim.
void MoveClear(PanelEmitter& panel, const Scene& scene, const glm::dvec3& aim)
{
  std::vector<glm::dvec3> places{ panel.centre };
  for (const double u : { -1.0, 0.0, 1.0 })
  {
    for (const double v : { -1.0, 0.0, 1.0 })
    {
      const double rim = panel.round && u * v != 0.0 ? std::sqrt(0.5) : 1.0;
      places.push_back(panel.centre + rim * (u * panel.acrossU + v * panel.acrossV));
    }
  }
  panel.centre += WayClearOfFacets(scene, places, aim);
}

glm::dvec3 WidthAxis(const RectangleLamp& lamp, const glm::dvec3& aim)
{
  constexpr double Parallel = 1e-6; // sine between the two axes
  if (lamp.across != glm::dvec3(0.0))
  {
    const glm::dvec3 across = CheckedDirection(lamp.across, "lamp width's axis");
    const glm::dvec3 inPlane = across - glm::dot(across, aim) * aim;
    if (!(glm::length(inPlane) > Parallel))
    {
      RefuseLamp("lamp width's axis runs along the lamp's direction");
    }
    return glm::normalize(inPlane);
  }
  const glm::dvec3 level = glm::cross(glm::dvec3(0.0, 0.0, 1.0), aim);
  return glm::length(level) > Parallel ? glm::normalize(level) : glm::dvec3(1.0, 0.0, 0.0);
}

} // namespace

RectangleLamp::PanelAxes RectangleLamp::Axes() const
{
  const glm::dvec3 aim = CheckedDirection(this->direction);
  const glm::dvec3 alongWidth = WidthAxis(*this, aim);
  return { aim, alongWidth, glm::cross(aim, alongWidth) };
}

void RectangleLamp::Move(const Similarity& motion)
{
  this->across = motion.Direction(this->Axes().width);
  this->centre = motion.Point(this->centre);
  this->direction = motion.Direction(this->direction);
  this->width *= motion.scale;
  this->height *= motion.scale;
}

void DiskLamp::Move(const Similarity& motion)
{
  this->centre = motion.Point(this->centre);
  this->direction = motion.Direction(this->direction);
  this->radius *= motion.scale;
}

Prepared<PanelEmitter> RectangleLamp::Prepare(const Scene& scene) const
{
  const PanelAxes axes = this->Axes();
  const double halfWidth = 0.5 * CheckedLength(this->width, scene, "lamp width");
  const double halfHeight = 0.5 * CheckedLength(this->height, scene, "lamp height");
  PanelEmitter panel{ {}, CheckedPosition(this->centre, scene), FrameOf(axes.aim),
    halfWidth * axes.width, halfHeight * axes.height, false };
  MoveClear(panel, scene, axes.aim);
  return { panel, CheckedFlux(this->flux) };
}

Prepared<PanelEmitter> DiskLamp::Prepare(const Scene& scene) const
{
  const glm::dvec3 aim = CheckedDirection(this->direction);
  const Frame frame = FrameOf(aim);
  const double length = CheckedLength(this->radius, scene, "lamp radius");
  PanelEmitter panel{ {}, CheckedPosition(this->centre, scene), frame,
    length * glm::dvec3(frame.tangent), length * glm::dvec3(frame.bitangent), true };
  MoveClear(panel, scene, aim);
  return { panel, CheckedFlux(this->flux) };
}

Ray PanelEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const float u = sample.Emission(0);
  const float v = sample.Emission(1);
  const glm::dvec2 p(
    this->round ? ConcentricDisk(u, v) : glm::vec2(2.0f * u - 1.0f, 2.0f * v - 1.0f));
  return RayFrom(this->centre + p.x * this->acrossU + p.y * this->acrossV,
    this->frame.ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

} // namespace PhotonTransport
