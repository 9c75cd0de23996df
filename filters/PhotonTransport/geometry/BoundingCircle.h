// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace PhotonTransport
{

struct Circle
{
  glm::dvec2 centre{ 0.0 };
  double radius = 0.0;
};

/// The smallest circle that holds all points, to rounding; none is outside. E. Welzl, "Smallest
/// enclosing disks (balls and ellipsoids)", 1991, in its incremental form: linear expected time.
Circle BoundingCircle(std::vector<glm::dvec2> points);

} // namespace PhotonTransport
