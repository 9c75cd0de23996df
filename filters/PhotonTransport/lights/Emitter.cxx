// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Emitter.h"

#include "PhotonTransport/geometry/BoundingCircle.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace PhotonTransport
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Rounding of scene coordinates, with room to spare.
constexpr double FloatSlack = 1e-6;

/// Every point of the scene is within this distance of the scene's origin: sqrt(3), rounded up.
constexpr double SceneRadius = 1.7321;

/// Scene units. Embree ends the process at a ray that starts beyond 1.8e18, where squares leave the
/// range of a float; a panel's point is the sum of three lengths.
constexpr double Farthest = 0x1p59;

[[noreturn]] void RefuseLamp(const std::string& message)
{
  throw InvalidInput(InvalidInput::Where::LampSettings, 0, message);
}

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string Text(const glm::dvec3& v)
{
  return '(' + Text(v.x) + ", " + Text(v.y) + ", " + Text(v.z) + ')';
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double CheckedAmount(double amount, const char* what)
{
  if (!(amount >= 0.0) || !std::isfinite(amount))
  {
    RefuseLamp(std::string(what) + " " + Text(amount) + " is not a finite number >= 0");
  }
  return amount;
}

/// In scene units.
double CheckedLength(double length, const Scene& scene, const char* what)
{
  const double inScene = scene.GetPlacement().LengthToScene(CheckedAmount(length, what));
  if (!(inScene <= Farthest))
  {
    RefuseLamp(std::string(what) + " " + Text(length) + " is more than " + Text(Farthest) +
      " times the size of the surface");
  }
  return inScene;
}

/// In scene coordinates.
glm::dvec3 CheckedPosition(const glm::dvec3& position, const Scene& scene)
{
  if (!IsFinite(position))
  {
    RefuseLamp("lamp position " + Text(position) + " is not finite");
  }
  const glm::dvec3 inScene = scene.GetPlacement().PointToScene(position);
  if (!(std::max({ std::fabs(inScene.x), std::fabs(inScene.y), std::fabs(inScene.z) }) <= Farthest))
  {
    RefuseLamp("lamp position " + Text(position) + " is more than " + Text(Farthest) +
      " times the size of the surface away from it");
  }
  return inScene;
}

glm::dvec3 CheckedDirection(const glm::dvec3& direction)
{
  const double largest =
    std::max({ std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z) });
  if (!IsFinite(direction) || !(largest > 0.0))
  {
    RefuseLamp(
      "lamp direction " + Text(direction) + " has no direction: it must be finite and not zero");
  }
  return glm::normalize(direction / largest);
}

Frame FrameOf(const glm::dvec3& unitDirection)
{
  return Frame(glm::vec3(unitDirection));
}

/// Starts a photon of a far lamp just outside the scene: in float, the last digits of a far origin
/// would displace the hit.
Ray RayFrom(glm::dvec3 origin, const glm::vec3& direction)
{
  constexpr double Far = 2.0;
  if (glm::dot(origin, origin) > Far * Far)
  {
    const glm::dvec3 along(direction);
    origin += std::max(0.0, -glm::dot(origin, along) - Far) * along;
  }
  return { glm::vec3(origin), direction };
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

struct Prepared
{
  std::variant<ParallelEmitter, ConeEmitter, PanelEmitter, FacetEmitter, SkyEmitter> source;
  double flux;
};

Prepared Prepare(const ParallelLight& light, const Scene& scene)
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

Prepared Prepare(const PointLamp& lamp, const Scene& scene)
{
  return { ConeEmitter{
             CheckedPosition(lamp.position, scene), FrameOf({ 0.0, 0.0, 1.0 }), 0.0f, -1.0f },
    CheckedAmount(lamp.flux, "luminous flux") };
}

Prepared Prepare(const LambertianPointLamp& lamp, const Scene& scene)
{
  return { ConeEmitter{ CheckedPosition(lamp.position, scene),
             FrameOf(CheckedDirection(lamp.direction)), 1.0f, 0.0f },
    CheckedAmount(lamp.flux, "luminous flux") };
}

Prepared Prepare(const SpotLamp& lamp, const Scene& scene)
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
  return { ConeEmitter{ CheckedPosition(lamp.position, scene),
             FrameOf(CheckedDirection(lamp.direction)), static_cast<float>(lamp.exponent),
             lamp.exponent > 0.0 ? std::max(0.0f, cosMax) : cosMax },
    CheckedAmount(lamp.flux, "luminous flux") };
}

Prepared Prepare(const RectangleLamp& lamp, const Scene& scene)
{
  const glm::dvec3 direction = CheckedDirection(lamp.direction);
  glm::dvec3 across = glm::cross(glm::dvec3(0.0, 0.0, 1.0), direction);
  constexpr double Vertical = 1e-6;
  across = glm::length(across) > Vertical ? glm::normalize(across) : glm::dvec3(1.0, 0.0, 0.0);
  const double width = CheckedLength(lamp.width, scene, "lamp width");
  const double height = CheckedLength(lamp.height, scene, "lamp height");
  return { PanelEmitter{ CheckedPosition(lamp.centre, scene), FrameOf(direction),
             0.5 * width * across, 0.5 * height * glm::cross(direction, across), false },
    CheckedAmount(lamp.flux, "luminous flux") };
}

Prepared Prepare(const DiskLamp& lamp, const Scene& scene)
{
  const Frame frame = FrameOf(CheckedDirection(lamp.direction));
  const double radius = CheckedLength(lamp.radius, scene, "lamp radius");
  return { PanelEmitter{ CheckedPosition(lamp.centre, scene), frame,
             radius * glm::dvec3(frame.tangent), radius * glm::dvec3(frame.bitangent), true },
    CheckedAmount(lamp.flux, "luminous flux") };
}

Prepared Prepare(const EmittingFacets&, const Scene& scene)
{
  FacetEmitter emitter{ &scene, {}, {}, {} };
  double sum = 0.0;
  for (std::uint32_t f = 0; f < scene.Exitance().size(); ++f)
  {
    if (scene.Exitance()[f] > 0.0f)
    {
      sum += scene.Exitance()[f] * double{ glm::length(scene.AreaVectors()[f]) };
      emitter.facets.push_back(f);
      emitter.cumulativeFlux.push_back(sum);
    }
  }
  if (!(sum > 0.0))
  {
    RefuseLamp("no facet has an exitance above 0 lm/m^2");
  }
  for (double& value : emitter.cumulativeFlux)
  {
    value /= sum;
  }
  std::uint32_t facet = 0;
  const std::size_t parts = emitter.facets.size();
  for (std::size_t part = 0; part < parts; ++part)
  {
    const double start = static_cast<double>(part) / static_cast<double>(parts);
    while (facet + 1 < parts && emitter.cumulativeFlux[facet] <= start)
    {
      ++facet;
    }
    emitter.firstOfPart.push_back(facet);
  }
  return { std::move(emitter), sum * scene.SquareMetresPerSceneArea() };
}

Prepared Prepare(const UniformSky& sky, const Scene& scene)
{
  double radius = 0.0;
  for (const Vertex& vertex : scene.Vertices())
  {
    if (vertex.inverseThreeAreas > 0.0f)
    {
      radius = std::max(radius, glm::length(glm::dvec3(vertex.position)));
    }
  }
  radius += FloatSlack;
  // Each direction sends L times the ball's cross-section; integrate over the solid angle.
  const double crossSection = Pi * radius * radius * scene.SquareMetresPerSceneArea();
  const double solidAngle = sky.wholeSphere ? 4.0 * Pi : 2.0 * Pi;
  return { SkyEmitter{
             FrameOf(CheckedDirection(sky.up)), sky.wholeSphere, static_cast<float>(radius) },
    CheckedAmount(sky.luminance, "luminance") * crossSection * solidAngle };
}

template <typename AnyLamp>
Prepared Prepare(const AnyLamp&, const Scene&)
{
  RefuseLamp("to be written");
}

} // namespace

Emitter::Emitter(const Lamp& lamp, const Scene& scene)
{
  Prepared prepared = std::visit([&](const auto& l) { return Prepare(l, scene); }, lamp);
  this->Source = std::move(prepared.source);
  this->TotalFlux = prepared.flux;
}

Ray ParallelEmitter::Emit(const PhotonSample& sample) const
{
  const glm::vec2 p = ConcentricDisk(sample.Emission(0), sample.Emission(1));
  return { this->centre + p.x * this->acrossU + p.y * this->acrossV, this->direction };
}

Ray ConeEmitter::Emit(const PhotonSample& sample) const
{
  return RayFrom(this->position,
    this->axis.ToWorld(
      PowerCosineCone(sample.Emission(0), sample.Emission(1), this->exponent, this->cosMax)));
}

Ray PanelEmitter::Emit(const PhotonSample& sample) const
{
  const float u = sample.Emission(0);
  const float v = sample.Emission(1);
  const glm::dvec2 p(
    this->round ? ConcentricDisk(u, v) : glm::vec2(2.0f * u - 1.0f, 2.0f * v - 1.0f));
  return RayFrom(this->centre + p.x * this->acrossU + p.y * this->acrossV,
    this->frame.ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

Ray FacetEmitter::Emit(const PhotonSample& sample) const
{
  const double choice = sample.EmissionBits(PhotonSample::FacetDimension) * 0x1p-32;
  const auto parts = static_cast<double>(this->facets.size());
  std::size_t chosen = this->firstOfPart[static_cast<std::size_t>(choice * parts)];
  while (chosen + 1 < this->facets.size() && this->cumulativeFlux[chosen] <= choice)
  {
    ++chosen;
  }
  const Facet& facet = this->scene->Facets()[this->facets[chosen]];
  const glm::vec2 b = UniformTriangle(sample.Emission(0), sample.Emission(1));
  const glm::vec3 barycentric(std::max(0.0f, 1.0f - b.x - b.y), b.x, b.y);
  return { this->scene->SafeOrigin(facet, barycentric, true),
    Frame(facet.normal).ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))) };
}

Ray SkyEmitter::Emit(const PhotonSample& sample) const
{
  glm::vec3 from = UniformSphere(sample.Emission(2), sample.Emission(3));
  if (!this->wholeSphere)
  {
    from.z = std::fabs(from.z);
  }
  const Frame frame(this->up.ToWorld(from));
  const glm::vec2 p = this->radius * ConcentricDisk(sample.Emission(0), sample.Emission(1));
  return { p.x * frame.tangent + p.y * frame.bitangent + this->radius * frame.normal,
    -frame.normal };
}

} // namespace PhotonTransport
