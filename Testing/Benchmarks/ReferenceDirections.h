// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReferenceLamps.h"

#include "PhotonTransport/geometry/Placement.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

/// A rectangle to which some of the rays are sent from points before it, because light comes from
/// there: an opening, a bright ceiling. It stops nothing and only changes the noise.
struct Guide
{
  glm::dvec3 centre, halfWidth, halfHeight; ///< In the data's coordinates.
  glm::dvec3 normal;                        ///< Unit, towards the points that it serves.
};

/// Directions of rays from a point: cosine-distributed, and some to guides.
class ReferenceDirections
{
public:
  ReferenceDirections(
    const std::vector<Guide>& guides, const PhotonTransport::Placement& placement);

  /// A unit vector, which may point behind the surface if it goes to a guide.
  /// @param numbers, choice Random, in [0, 1).
  glm::dvec3 Draw(const LitPlace& from, const glm::dvec2& numbers, double choice) const;
  /// Of Draw, 1/sr.
  double Density(const LitPlace& from, const glm::dvec3& direction) const;

private:
  struct SceneGuide
  {
    glm::dvec3 centre, halfWidth, halfHeight, normal;
    double area;
    bool Serves(const glm::dvec3& position) const;
    double Density(const glm::dvec3& position, const glm::dvec3& direction) const;
  };
  std::vector<SceneGuide> Guides;
};
