// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// How far a lamp has to be moved, scene units, to stand clear of the facets that it touches; zero
/// for one that touches none. A recessed lamp lies in its ceiling's plane, and rounding would leave
/// it on either side. It stands on the side to which it shines, or, where it shines along a facet
/// or has no direction, in front of the facet. The way is far too short to change what the lamp
/// lights: some 2^-16 of the coordinates there.
/// @param places Points of the lamp, scene coordinates: its position, or its centre and rim.
/// @param aim Unit length, or zero for a lamp without a direction.
glm::dvec3 WayClearOfFacets(
  const Scene& scene, const std::vector<glm::dvec3>& places, const glm::dvec3& aim);

} // namespace PhotonTransport
