// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// A box that holds the places from which light comes, a cone that holds the directions that these
/// places face, and their flux.
struct LightBounds
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 half{ 0.0 };  ///< Half the box's lengths.
  glm::dvec3 axis{ 0.0 };  ///< Unit, of the cone.
  double cosSpread = -1.0; ///< Of the cone's half-angle; -1: they face every way.
  double sinSpread = 0.0;
  double flux = 0.0; ///< lm
};

/// What holds both.
LightBounds Joined(const LightBounds& a, const LightBounds& b);

/// About how bright the light is at a point that faces along a unit normal, to choose by: flux over
/// squared distance, times bounds of the cosines at both ends (Conty Estevez and Kulla, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting", 2018). It is 0 only where no light can
/// arrive: behind the point's horizon, or behind all that shines. Flat boxes tell of walls that a
/// point close to them in a corner sees their far parts edge on.
/// @param normal Zero if light counts alike from all directions.
double Brightness(const LightBounds& light, const glm::dvec3& point, const glm::dvec3& normal);

/// At least the cosine to the normal of each place in the box, and a little above 0 at least.
/// @param normal As above.
double CosineBound(const LightBounds& light, const glm::dvec3& point, const glm::dvec3& normal);

} // namespace PhotonTransport
