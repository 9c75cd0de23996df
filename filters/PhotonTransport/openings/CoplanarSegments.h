// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/OpenBorder.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

struct Plane
{
  glm::dvec3 point;
  glm::dvec3 normal; ///< Unit.

  double Distance(const glm::dvec3& to) const;
  /// A unit vector in the plane.
  glm::dvec3 AnyDirection() const;
};

/// Segments of a border that hang together and lie in a plane.
struct CoplanarSegments
{
  Plane plane;
  std::vector<std::uint32_t> segments; ///< Three or more.
};

/// Finds the flat parts of a border. A part that hangs together and is flat as a whole is one of
/// them; another one is divided by the planes of its corners, and a segment may be in several.
std::vector<CoplanarSegments> FindCoplanarSegments(const OpenBorder& border);

} // namespace PhotonTransport
