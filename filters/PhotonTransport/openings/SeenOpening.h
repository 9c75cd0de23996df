// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/sampling/SphericalTriangle.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace PhotonTransport
{

/// A direction from a point towards an opening.
struct OpeningSample
{
  glm::vec3 direction;   ///< Unit.
  float distance = 0.0f; ///< To the opening.
  /// One over the density by solid angle, sr: the integral of f over the directions in which the
  /// opening is seen is the mean of weight * f. 0 where it is not seen.
  float weight = 0.0f;
};

/// By how much the light from a direction counts for a surface, where light of directions that are
/// distributed as the cosine over pi counts 1. @param direction, normal Unit. @param weight As that
/// of OpeningSample.
inline double FactorOf(const glm::vec3& direction, double weight, const glm::vec3& normal)
{
  const double cosine = glm::dot(direction, normal);
  return weight * std::max(0.0, cosine) / Pi;
}

/// An opening as it is seen from a point, and directions towards it for numbers that may be
/// stratified. They are uniform by solid angle; where that is small, they go to points uniform by
/// area, which then is nearly the same.
class SeenOpening
{
public:
  /// @param opening Must outlive this.
  SeenOpening(const Opening& opening, const glm::vec3& from);

  /// sr; 0 on the outer side and in the opening's plane.
  double SolidAngle() const { return this->Angles.empty() ? 0.0 : this->Angles.back(); }

  /// @param u, v In [0, 1).
  OpeningSample Sample(float u, float v) const;

private:
  const Opening& Seen;
  glm::dvec3 From;
  double Height; ///< Over the opening's plane, inwards.
  std::vector<SphericalTriangle> Triangles;
  std::vector<double> Angles; ///< Of all triangles up to each, its own included.
};

} // namespace PhotonTransport
