// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// The vector at unit length, without overflow at 1e200 or underflow at 1e-200.
inline glm::dvec3 Unit(const glm::dvec3& v)
{
  return glm::normalize(v / std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) }));
}

/// The turn by the shortest way of a thing that aims along -z, to another aim; half a turn about x
/// to +z.
class ShortestTurn
{
public:
  /// @param aim Unit.
  explicit ShortestTurn(const glm::dvec3& aim)
    : Axis(glm::cross(Down, aim))
    , Cosine(glm::dot(Down, aim))
    , IsHalf(Cosine < -1.0 + 1e-12)
  {
  }

  /// The unit vector after the turn (Rodrigues).
  glm::dvec3 operator()(const glm::dvec3& v) const
  {
    return this->IsHalf ? glm::dvec3(v.x, -v.y, 0.0 - v.z)
                        : glm::normalize(this->Cosine * v + glm::cross(this->Axis, v) +
                            this->Axis * (glm::dot(this->Axis, v) / (1.0 + this->Cosine)));
  }

  /// What to turn about, of any length but 0.
  glm::dvec3 About() const
  {
    return this->IsHalf || glm::length(this->Axis) == 0.0 ? glm::dvec3(1.0, 0.0, 0.0) : this->Axis;
  }
  /// Radians.
  double Angle() const
  {
    return std::atan2(this->IsHalf ? 0.0 : glm::length(this->Axis), this->Cosine);
  }

private:
  static constexpr glm::dvec3 Down{ 0.0, 0.0, -1.0 };
  glm::dvec3 Axis; ///< As long as the sine of the angle.
  double Cosine;
  bool IsHalf;
};

/// A rotation, a translation, a uniform scale, and perhaps a mirror image.
struct Similarity
{
  bool isNone = true;       ///< Every point is where it was, to the last bit.
  bool mirrors = false;     ///< Left and right change places.
  double scale = 1.0;       ///< > 0.
  glm::dmat3 turn{ 1.0 };   ///< Orthogonal.
  glm::dvec3 before{ 0.0 }; ///< One point ...
  glm::dvec3 after{ 0.0 };  ///< ... and where it went.

  glm::dvec3 Direction(const glm::dvec3& v) const { return this->turn * v; }
  glm::dvec3 Point(const glm::dvec3& p) const
  {
    return this->after + this->scale * (this->turn * (p - this->before));
  }
};

} // namespace PhotonTransport
