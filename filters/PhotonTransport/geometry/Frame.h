// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace PhotonTransport
{

/// Right-handed orthonormal frame whose third axis is a given unit normal.
struct Frame
{
  glm::vec3 tangent;
  glm::vec3 bitangent;
  glm::vec3 normal;

  /// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017: no branch, and
  /// continuous everywhere but across the plane z = 0.
  explicit Frame(const glm::vec3& unitNormal)
    : normal(unitNormal)
  {
    const float sign = std::copysign(1.0f, unitNormal.z);
    const float a = -1.0f / (sign + unitNormal.z);
    const float b = unitNormal.x * unitNormal.y * a;
    tangent = { 1.0f + sign * unitNormal.x * unitNormal.x * a, sign * b, -sign * unitNormal.x };
    bitangent = { b, sign + unitNormal.y * unitNormal.y * a, -unitNormal.y };
  }

  glm::vec3 ToWorld(const glm::vec3& local) const
  {
    return local.x * tangent + local.y * bitangent + local.z * normal;
  }
};

} // namespace PhotonTransport
