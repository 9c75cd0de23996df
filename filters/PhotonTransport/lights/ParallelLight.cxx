// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/ParallelLight.h"

#include "PhotonTransport/geometry/BoundingCircle.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

namespace PhotonTransport
{
namespace
{

/// Every point of the scene is within this distance of the scene's origin: sqrt(3), rounded up.
constexpr double SceneRadius = 1.7321;

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

} // namespace

Prepared<ParallelEmitter> ParallelLight::Prepare(const Scene& scene) const
{
  const glm::dvec3 towards = CheckedDirection(this->direction);
  const Frame frame = FrameOf(towards);
  Circle circle = BoundingCircle(Shadow(scene, frame));
  circle.radius += FloatSlack;
  const auto radius = static_cast<float>(circle.radius);
  const glm::dvec3 centre = circle.centre.x * glm::dvec3(frame.tangent) +
    circle.centre.y * glm::dvec3(frame.bitangent) - SceneRadius * towards;
  const double area = Pi * circle.radius * circle.radius;
  return { { {}, glm::vec3(centre), radius * frame.tangent, radius * frame.bitangent, frame.normal,
             area },
    CheckedAmount(this->illuminance, "illuminance") * area * scene.SquareMetresPerSceneArea() };
}

Ray ParallelEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::vec2 p = sample.OnDisk(0);
  return { this->centre + p.x * this->acrossU + p.y * this->acrossV, this->direction };
}

} // namespace PhotonTransport
