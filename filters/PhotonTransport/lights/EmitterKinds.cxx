// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/EmitterKinds.h"

#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace PhotonTransport
{
namespace
{

constexpr float TwoPi = 6.28318530717958648f;

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

/// From far outside, in a direction opposite to `from`, onto the ball that holds the scene.
Ray OntoBall(const glm::vec3& from, float radius, const PhotonSample& sample)
{
  const Frame frame(from);
  const glm::vec2 p = radius * ConcentricDisk(sample.Emission(0), sample.Emission(1));
  return { p.x * frame.tangent + p.y * frame.bitangent + radius * frame.normal, -frame.normal };
}

/// Unit. @param angles From the pole, and about it from azimuth0 to azimuth90; radians.
glm::vec3 Direction(const glm::dvec2& angles, const glm::dvec3& azimuth0,
  const glm::dvec3& azimuth90, const glm::dvec3& pole)
{
  const double sine = std::sin(angles.x);
  return glm::normalize(glm::vec3(std::cos(angles.x) * pole +
    sine * (std::cos(angles.y) * azimuth0 + std::sin(angles.y) * azimuth90)));
}

} // namespace

Ray ParallelEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::vec2 p = ConcentricDisk(sample.Emission(0), sample.Emission(1));
  return { this->centre + p.x * this->acrossU + p.y * this->acrossV, this->direction };
}

Ray ConeEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  return RayFrom(this->position,
    this->axis.ToWorld(
      PowerCosineCone(sample.Emission(0), sample.Emission(1), this->exponent, this->cosMax)));
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

Ray FacetEmitter::Emit(const PhotonSample& sample, const Share& share) const
{
  const std::uint32_t facet = this->FacetOf(sample, share);
  const glm::vec2 b = UniformTriangle(sample.Emission(0), sample.Emission(1));
  const glm::vec3 barycentric(std::max(0.0f, 1.0f - b.x - b.y), b.x, b.y);
  return { this->scene->SafeOrigin(facet, barycentric, true),
    Frame(this->scene->Facets()[facet].normal)
      .ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))) };
}

Ray SkyEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  glm::vec3 from = UniformSphere(sample.Emission(2), sample.Emission(3));
  if (!this->wholeSphere)
  {
    from.z = std::fabs(from.z);
  }
  return OntoBall(this->up.ToWorld(from), this->radius, sample);
}

Ray TableSkyEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  // One number chooses the side of the sun and the azimuth there; next to each other in the number
  // is next to each other in the sky, across the sun's meridian too.
  const double turn = 2.0 * sample.Emission(3) - 1.0;
  const glm::dvec2 angles =
    this->table->Sample(sample.Emission(2), std::min(std::fabs(turn), 1.0 - 0x1p-53));
  const glm::dvec3 beside = turn < 0.0 ? -this->azimuth90 : this->azimuth90;
  return OntoBall(Direction(angles, this->azimuth0, beside, this->up), this->radius, sample);
}

Ray TableEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::dvec2 angles = this->table->Sample(sample.Emission(0), sample.Emission(1));
  return RayFrom(this->position, Direction(angles, this->azimuth0, this->azimuth90, this->pole));
}

Ray SphereEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::vec3 normal = glm::normalize(UniformSphere(sample.Emission(0), sample.Emission(1)));
  return RayFrom(this->centre + this->radius * glm::dvec3(normal),
    Frame(normal).ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

Ray LineEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const double along = 2.0 * double{ sample.Emission(0) } - 1.0;
  const float azimuth = TwoPi * sample.Emission(1);
  const glm::vec3 normal = this->frame.ToWorld({ std::cos(azimuth), std::sin(azimuth), 0.0f });
  return RayFrom(this->centre + along * this->halfAxis,
    Frame(glm::normalize(normal))
      .ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3))));
}

Ray MeshEmitter::Emit(const PhotonSample& sample, const Share& share) const
{
  const Triangle& triangle = this->triangles[this->table.At(share.PlaceOf(sample))];
  const glm::dvec2 b(UniformTriangle(sample.Emission(0), sample.Emission(1)));
  const glm::vec3 direction =
    Frame(triangle.normal).ToWorld(CosineHemisphere(sample.Emission(2), sample.Emission(3)));
  return RayFrom(triangle.corner + b.x * triangle.u + b.y * triangle.v, direction);
}

} // namespace PhotonTransport
