// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// Where the scene's own coordinates lie in the data's. Embree computes in float, so the scene is
/// moved to the origin and scaled into [-1, 1] in double first. The scale is a power of two, so
/// that scaling rounds nothing.
struct Placement
{
  glm::dvec3 centre{ 0.0 };
  double scale = 1.0; ///< Scene length per data length; a power of two.

  glm::dvec3 PointToScene(const glm::dvec3& point) const { return (point - centre) * scale; }
  double LengthToScene(double length) const { return length * scale; }
};

/// The placement that puts all `points[i]`, for every index i in `facets`, into [-1, 1]. The origin
/// is the middle of their bounding box, or the place of the finest facets where those are much
/// finer than the rest: coordinates are finest next to the origin. All coordinates must be finite.
Placement FitPlacement(
  const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets);

} // namespace PhotonTransport
