// SPDX-License-Identifier: BSD-3-Clause
// What the lamps' photons have in common where they start.
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Ray.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace PhotonTransport
{

/// The slice of [0, 1) that selects this lamp; the position inside it is reused as a fresh uniform
/// number.
struct Share
{
  double begin = 0.0;
  double width = 1.0;

  double PlaceOf(const PhotonSample& sample) const
  {
    const double choice = sample.EmissionBits(PhotonSample::ChoiceDimension) * 0x1p-32;
    constexpr double Last = 1.0 - 0x1p-53;
    return std::clamp((choice - this->begin) / this->width, 0.0, Last);
  }
};

inline Frame FrameOf(const glm::dvec3& unitDirection)
{
  return Frame(glm::vec3(unitDirection));
}

/// Starts a photon of a far lamp just outside the scene: in float, the last digits of a far origin
/// would displace the hit.
inline Ray RayFrom(glm::dvec3 origin, const glm::vec3& direction)
{
  constexpr double Far = 2.0;
  if (glm::dot(origin, origin) > Far * Far)
  {
    const glm::dvec3 along(direction);
    origin += std::max(0.0, -glm::dot(origin, along) - Far) * along;
  }
  return { glm::vec3(origin), direction };
}

} // namespace PhotonTransport
