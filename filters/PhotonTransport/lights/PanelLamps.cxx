// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/PanelLamps.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LambertPolygon.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/lights/SphericalRectangle.h"
#include "PhotonTransport/sampling/Warps.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// From farther than so many times the root of the squared half-axes places of a rectangle are
/// drawn by area.
constexpr double FarFromRectangle = 4.0;

/// The same of a disk, in radii from its nearest place.
constexpr double FarFromDisk = 0.5;

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
    this->frame.ToWorld(CosineHemisphereAbove(sample.OnDisk(1))));
}

Incidence PanelEmitter::Arriving(const glm::dvec3& point, float u, float v) const
{
  const glm::dvec3 across = glm::cross(this->acrossU, this->acrossV);
  const double area = glm::length(across);
  const glm::dvec3 normal = area > 0.0 ? across / area : glm::dvec3(this->frame.normal);
  const glm::dvec3 way = point - this->centre;
  const double height = glm::dot(way, normal);
  if (!(height > 0.0))
  {
    return {}; // it shines to one side
  }
  if (!(area > 0.0) || !this->IsNear(way, height))
  {
    return this->ByArea(point, normal, u, v);
  }
  return this->round ? this->FromDisk(point, normal, height, u, v)
                     : this->FromRectangle(point, normal, height, u, v);
}

/// Whether the illuminance of equal areas of the panel varies much. @param way From its centre.
bool PanelEmitter::IsNear(const glm::dvec3& way, double height) const
{
  const double u2 = glm::dot(this->acrossU, this->acrossU);
  const double d2 = glm::dot(way, way);
  if (!this->round)
  {
    const double v2 = glm::dot(this->acrossV, this->acrossV);
    return d2 < FarFromRectangle * FarFromRectangle * (u2 + v2);
  }
  const double radius = std::sqrt(u2);
  const double aside = std::sqrt(std::max(0.0, d2 - height * height));
  return std::hypot(height, std::max(0.0, aside - radius)) < FarFromDisk * radius;
}

Incidence PanelEmitter::ByArea(
  const glm::dvec3& point, const glm::dvec3& normal, float u, float v) const
{
  const glm::dvec2 p(
    this->round ? ConcentricDisk(u, v) : glm::vec2(2.0f * u - 1.0f, 2.0f * v - 1.0f));
  const glm::dvec3 place = this->centre + p.x * this->acrossU + p.y * this->acrossV;
  const glm::dvec3 way = point - place;
  const double d2 = glm::dot(way, way);
  return { point, place, std::max(0.0, glm::dot(way, normal)) / (Pi * std::sqrt(d2) * d2) };
}

Incidence PanelEmitter::FromRectangle(
  const glm::dvec3& point, const glm::dvec3& normal, double height, float u, float v) const
{
  const double halfU = glm::length(this->acrossU), halfV = glm::length(this->acrossV);
  const glm::dvec3 axisU = this->acrossU / halfU, axisV = this->acrossV / halfV;
  const glm::dvec3 way = this->centre - point;
  const glm::dvec2 middle(glm::dot(way, axisU), glm::dot(way, axisV));
  const glm::dvec2 half(halfU, halfV);
  const SphericalRectangle seen(glm::dvec3(middle - half, -height), 2.0 * half);
  // Edge on, an angle so small is what rounding has left of larger ones.
  constexpr double Least = 1e-7;
  if (!(seen.SolidAngle() > Least))
  {
    return this->ByArea(point, normal, u, v);
  }
  const glm::dvec2 place = seen.Place(double{ u }, double{ v }) - middle;
  return { point, this->centre + place.x * axisU + place.y * axisV,
    seen.SolidAngle() / (Pi * 4.0 * halfU * halfV) };
}

Incidence PanelEmitter::FromDisk(
  const glm::dvec3& point, const glm::dvec3& normal, double height, float u, float v) const
{
  // In polar coordinates about the foot of the point in the disk's plane the solid angle is the
  // integral of d(angle) d(1 - height / sqrt(height^2 + r^2)). The second part has even density
  // between the two ends of the disk in a direction, and the angle has even density.
  const double radius = glm::length(this->acrossU);
  const glm::dvec3 foot = point - height * normal - this->centre;
  const double aside = glm::length(foot);
  const glm::dvec3 inwards = aside > 0.0 ? -foot / aside : this->acrossU / radius;
  const glm::dvec3 sideways = glm::cross(normal, inwards);
  double angle = (2.0 * double{ u } - 1.0) * Pi;
  double range = 2.0 * Pi;
  if (aside >= radius)
  {
    const double edge = std::asin(radius / aside);
    angle = (2.0 * double{ u } - 1.0) * edge;
    range = 2.0 * edge;
  }
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const double chord = std::sqrt(std::max(0.0, radius * radius - aside * aside * sine * sine));
  const double r1 = std::max(0.0, aside >= radius ? aside * cosine - chord : 0.0);
  const double r2 = std::max(r1, aside * cosine + chord);
  const double above1 = height / std::hypot(height, r1), above2 = height / std::hypot(height, r2);
  const double above = above1 + double{ v } * (above2 - above1);
  const double r =
    std::clamp(height * std::sqrt(std::max(0.0, (1.0 - above) * (1.0 + above))) / above, r1, r2);
  const glm::dvec3 place = this->centre + foot + r * (cosine * inwards + sine * sideways);
  return { point, place, range * (above1 - above2) / (Pi * Pi * radius * radius) };
}

std::optional<double> PanelEmitter::Unobstructed(
  const glm::dvec3& point, const glm::dvec3& normal) const
{
  const glm::dvec3 across = glm::cross(this->acrossU, this->acrossV);
  const double area = glm::length(across);
  const glm::dvec3 way = this->centre - point;
  if (!(glm::dot(way, across) < 0.0))
  {
    return area > 0.0 ? std::optional(0.0) : std::nullopt;
  }
  const double size = glm::length(this->acrossU) + glm::length(this->acrossV);
  constexpr double Far = 1e4; // sizes; from there on little is left of the formulas' digits
  if (glm::length(way) > Far * size)
  {
    return std::nullopt;
  }
  if (!this->round)
  {
    return ConfigurationFactor(
             { way - this->acrossU - this->acrossV, way + this->acrossU - this->acrossV,
               way + this->acrossU + this->acrossV, way - this->acrossU + this->acrossV },
             normal) /
      (4.0 * area);
  }
  // Howell, catalog B-13 and B-14 (planes along and across the disk), which are the parts of the
  // irradiance vector as long as all of the disk stands above the horizon.
  const glm::dvec3 axis = across / area;
  const double h = -glm::dot(way, axis);
  const glm::dvec3 sideways = way + h * axis;
  const double a = glm::length(sideways);
  const double r = glm::length(this->acrossU);
  const double slant = glm::length(normal - glm::dot(normal, axis) * axis);
  if (!(glm::dot(way, normal) > r * slant))
  {
    return std::nullopt;
  }
  const double sum = h * h + a * a + r * r;
  const double root = std::sqrt((h * h + (a - r) * (a - r)) * (h * h + (a + r) * (a + r)));
  double factor = -glm::dot(normal, axis) * 0.5 * (1.0 - (sum - 2.0 * r * r) / root);
  if (a > 0.0)
  {
    // Z / root - 1 of the catalog, whose difference would lose digits.
    const double excess = 4.0 * a * a * r * r / (root * (sum + root));
    factor += glm::dot(normal, sideways) / a * 0.5 * (h / a) * excess;
  }
  return std::max(0.0, factor) / (Pi * r * r);
}

} // namespace PhotonTransport
