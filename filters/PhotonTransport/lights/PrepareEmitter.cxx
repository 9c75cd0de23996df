// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/PrepareEmitter.h"

#include "PhotonTransport/geometry/BoundingCircle.h"
#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/EmittingSurfaces.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/LampTables.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace PhotonTransport
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Rounding of scene coordinates, with room to spare.
constexpr double FloatSlack = 1e-6;

/// Every point of the scene is within this distance of the scene's origin: sqrt(3), rounded up.
constexpr double SceneRadius = 1.7321;

Frame FrameOf(const glm::dvec3& unitDirection)
{
  return Frame(glm::vec3(unitDirection));
}

/// In scene coordinates, clear of facets. @param aim Unit, or zero.
glm::dvec3 ClearPosition(
  const glm::dvec3& position, const Scene& scene, const glm::dvec3& aim = glm::dvec3(0.0))
{
  const glm::dvec3 place = CheckedPosition(position, scene);
  return place + WayClearOfFacets(scene, { place }, aim);
}

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

/// The scene's shadow under parallel light, in the plane of the frame's tangents.
std::vector<glm::dvec2> Shadow(const Scene& scene, const Frame& frame)
{
  std::vector<glm::dvec2> shadow;
  shadow.reserve(scene.Vertices().size());
  for (const Vertex& vertex : scene.Vertices())
  {
    if (vertex.inverseThreeAreas > 0.0f)
    {
      const glm::dvec3 p(vertex.position);
      shadow.emplace_back(
        glm::dot(p, glm::dvec3(frame.tangent)), glm::dot(p, glm::dvec3(frame.bitangent)));
    }
  }
  return shadow;
}

/// Of the ball about the scene's origin that holds all facets.
double BallRadius(const Scene& scene)
{
  double radius = 0.0;
  for (const Vertex& vertex : scene.Vertices())
  {
    if (vertex.inverseThreeAreas > 0.0f)
    {
      radius = std::max(radius, glm::length(glm::dvec3(vertex.position)));
    }
  }
  return radius + FloatSlack;
}

/// m^2 that the ball shows to each direction.
double CrossSection(double radius, const Scene& scene)
{
  return Pi * radius * radius * scene.SquareMetresPerSceneArea();
}

PreparedEmitter Prepare(const ParallelLight& light, const Scene& scene)
{
  const glm::dvec3 direction = CheckedDirection(light.direction);
  const Frame frame = FrameOf(direction);
  Circle circle = BoundingCircle(Shadow(scene, frame));
  circle.radius += FloatSlack;
  const auto radius = static_cast<float>(circle.radius);
  const glm::dvec3 centre = circle.centre.x * glm::dvec3(frame.tangent) +
    circle.centre.y * glm::dvec3(frame.bitangent) - SceneRadius * direction;
  const double area = Pi * circle.radius * circle.radius * scene.SquareMetresPerSceneArea();
  return { ParallelEmitter{
             glm::vec3(centre), radius * frame.tangent, radius * frame.bitangent, frame.normal },
    CheckedAmount(light.illuminance, "illuminance") * area };
}

PreparedEmitter Prepare(const PointLamp& lamp, const Scene& scene)
{
  return { ConeEmitter{
             ClearPosition(lamp.position, scene), FrameOf({ 0.0, 0.0, 1.0 }), 0.0f, -1.0f },
    CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const LambertianPointLamp& lamp, const Scene& scene)
{
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  return { ConeEmitter{
             ClearPosition(lamp.position, scene, direction), FrameOf(direction), 1.0f, 0.0f },
    CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const SpotLamp& lamp, const Scene& scene)
{
  const double widest = lamp.exponent > 0.0 ? 0.5 * Pi : Pi;
  if (!(lamp.halfAngle > 0.0 && lamp.halfAngle <= widest * (1.0 + 1e-12)))
  {
    RefuseLamp("spot half-angle " + std::to_string(lamp.halfAngle * 180.0 / Pi) +
      " degrees is outside (0, " + std::to_string(widest * 180.0 / Pi) +
      "] (an exponent above 0 ends at 90)");
  }
  CheckedAmount(lamp.exponent, "spot exponent");
  const auto cosMax = static_cast<float>(std::cos(lamp.halfAngle));
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  return { ConeEmitter{ ClearPosition(lamp.position, scene, direction), FrameOf(direction),
             static_cast<float>(lamp.exponent),
             lamp.exponent > 0.0 ? std::max(0.0f, cosMax) : cosMax },
    CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const RectangleLamp& lamp, const Scene& scene)
{
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  const glm::dvec3 across = WidthAxis(lamp, direction);
  const double width = CheckedLength(lamp.width, scene, "lamp width");
  const double height = CheckedLength(lamp.height, scene, "lamp height");
  PanelEmitter panel{ CheckedPosition(lamp.centre, scene), FrameOf(direction), 0.5 * width * across,
    0.5 * height * glm::cross(direction, across), false };
  MoveClear(panel, scene, direction);
  return { panel, CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const DiskLamp& lamp, const Scene& scene)
{
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  const Frame frame = FrameOf(direction);
  const double radius = CheckedLength(lamp.radius, scene, "lamp radius");
  PanelEmitter panel{ CheckedPosition(lamp.centre, scene), frame,
    radius * glm::dvec3(frame.tangent), radius * glm::dvec3(frame.bitangent), true };
  MoveClear(panel, scene, direction);
  return { panel, CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const UniformSky& sky, const Scene& scene)
{
  const double radius = BallRadius(scene);
  const double solidAngle = sky.wholeSphere ? 4.0 * Pi : 2.0 * Pi;
  return { SkyEmitter{
             FrameOf(CheckedDirection(sky.up)), sky.wholeSphere, static_cast<float>(radius) },
    CheckedAmount(sky.luminance, "luminance") * CrossSection(radius, scene) * solidAngle };
}

PreparedEmitter Prepare(const SphereLamp& lamp, const Scene& scene)
{
  return { SphereEmitter{
             ClearPosition(lamp.centre, scene), CheckedLength(lamp.radius, scene, "lamp radius") },
    CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const LineLamp& lamp, const Scene& scene)
{
  const glm::dvec3 axis = CheckedDirection(lamp.axis, "lamp axis");
  const double length = CheckedLength(lamp.length, scene, "lamp length");
  LineEmitter tube{ CheckedPosition(lamp.centre, scene), 0.5 * length * axis, FrameOf(axis) };
  tube.centre += WayClearOfFacets(scene,
    { tube.centre, tube.centre - tube.halfAxis, tube.centre + tube.halfAxis,
      tube.centre - 0.5 * tube.halfAxis, tube.centre + 0.5 * tube.halfAxis },
    glm::dvec3(0.0));
  return { tube, CheckedAmount(lamp.flux, "luminous flux") };
}

PreparedEmitter Prepare(const PhotometricLamp& lamp, const Scene& scene)
{
  if (!std::isfinite(lamp.rotation))
  {
    RefuseLamp("lamp rotation " + Text(lamp.rotation) + " is not finite");
  }
  const auto table = TableOf(lamp.solid);
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  const LampAxes axes = AxesOf(direction, lamp.rotation);
  const glm::dvec3 position = ClearPosition(lamp.position, scene, direction);
  const double flux = CheckedAmount(lamp.scale, "dimming") * table->Integral();
  // See PhotometricSolid.
  switch (lamp.solid.type)
  {
    case PhotometricSolid::Type::A:
      return { TableEmitter{ position, axes.aim, axes.x, axes.y, table }, flux };
    case PhotometricSolid::Type::B:
      return { TableEmitter{ position, axes.aim, axes.y, axes.x, table }, flux };
    default:
      return { TableEmitter{ position, axes.x, axes.y, axes.aim, table }, flux };
  }
}

PreparedEmitter Prepare(const CieSky& sky, const Scene& scene)
{
  if (sky.type < 1 || sky.type > 16)
  {
    RefuseLamp("sky type " + std::to_string(sky.type) + " is outside 1 to 16");
  }
  const double sunZenithAngle = SunZenithAngle(sky);
  const glm::dvec3 up = CheckedDirection(sky.up);
  const glm::dvec3 sun = CheckedDirection(sky.sun);
  const glm::dvec3 level = sun - glm::dot(sun, up) * up;
  const glm::dvec3 towardsSun =
    glm::length(level) > FloatSlack ? glm::normalize(level) : glm::dvec3(FrameOf(up).tangent);
  const auto table = std::make_shared<const DirectionTable>(SkyTable(sky.type, sunZenithAngle));
  const double radius = BallRadius(scene);
  return { TableSkyEmitter{
             towardsSun, glm::cross(up, towardsSun), up, static_cast<float>(radius), table },
    ZenithLuminance(sky, *table) * 2.0 * table->Integral() * CrossSection(radius, scene) };
}

} // namespace

PreparedEmitter PrepareEmitter(const Lamp& lamp, const Scene& scene)
{
  return std::visit([&](const auto& l) { return Prepare(l, scene); }, lamp);
}

} // namespace PhotonTransport
