// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// Half a unit in the last place of a number in single precision, relative to the number.
constexpr double SingleHalfUnit = 0x1p-24;

/// How far points may lie from where they were meant, since the data's coordinates were rounded
/// before the scene got them (Surface::rounding). In scene units; far from the data's origin this
/// is much more than the rounding of the scene's own coordinates.
struct DataRounding
{
  glm::dvec3 origin{ 0.0 }; ///< Of the data, in the scene's coordinates.
  double relative = 0.0;    ///< To each coordinate of the data.

  /// How far a point may be off in a direction of unit length. A triangle of such points is as far
  /// off its plane at most.
  double Along(const glm::dvec3& direction, const glm::dvec3& point) const
  {
    return this->relative * glm::dot(glm::abs(direction), glm::abs(point - this->origin));
  }
};

} // namespace PhotonTransport
