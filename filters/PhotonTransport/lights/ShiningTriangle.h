// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace PhotonTransport
{

/// A triangle that shines by Lambert's law from one side, as it is seen from a point.
struct ShiningTriangle
{
  glm::dvec3 corner, u, v; ///< A corner and the edges to the two others.
  glm::dvec3 normal;       ///< Unit, on the side that shines.

  /// A place on it, and the illuminance of a surface that faces it (Incidence::perLumen).
  struct Seen
  {
    glm::dvec2 barycentric{ 1.0 / 3.0 }; ///< Of the second and the third corner.
    double perLumen = 0.0;
    glm::dvec3 place{ 0.0 };
  };

  /// From near by places are drawn with even density by solid angle, so that the illuminance stays
  /// bounded: Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995. From far they are
  /// drawn by area. @param a, b In [0, 1).
  Seen From(const glm::dvec3& point, float a, float b) const;

  /// See LampKind.h.
  std::optional<double> Unobstructed(const glm::dvec3& point, const glm::dvec3& facing) const;

private:
  Seen ByArea(const glm::dvec3& point, float a, float b) const;
};

} // namespace PhotonTransport
