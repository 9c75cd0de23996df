// SPDX-License-Identifier: BSD-3-Clause
// A lamp that lights a surface of which nothing else is known.
#ifndef SuggestedLamp_h
#define SuggestedLamp_h

#include <glm/vec3.hpp>

#include <vector>

namespace Illumination
{

/// The triangles of a surface, with the normals that say which side is lit.
struct LitTriangles
{
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> normals; ///< Of each point; zero: as the triangles are wound.
  std::vector<glm::uvec3> facets;
};

struct SuggestedLamp
{
  bool isParallel = true;               ///< Parallel light, or a point.
  glm::dvec3 position{ 0.0, 0.0, 1.0 }; ///< Of the point, or off the surface on its lit side.
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double size = 1.0; ///< Of a lamp that suits the surface, data's length.
};

/// In a room, whose normals point inward, a point below the ceiling; else parallel light onto the
/// side to which most normals point, from +z if that is no less lit. Up is +z.
SuggestedLamp SuggestLamp(const LitTriangles& surface);

} // namespace Illumination

#endif
