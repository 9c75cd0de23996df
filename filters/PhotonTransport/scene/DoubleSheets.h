// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <optional>

namespace PhotonTransport
{

/// Barycentric coordinates of a point in a triangle, each in [0, 1]; nothing for a point that is
/// farther than the gap from its plane or beyond one of its edges.
std::optional<glm::vec3> Within(const glm::dvec3& point, double gap, const glm::dvec3& a,
  const glm::dvec3& b, const glm::dvec3& c);

} // namespace PhotonTransport
