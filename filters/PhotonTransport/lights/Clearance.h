// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// The vector, in scene units, by which a lamp has to be moved to stand clear of the facets that it
/// touches; zero for a lamp that touches none. A recessed lamp lies in its ceiling's plane, and
/// rounding would put it on either side. It is moved to the side to which it shines, or, where it
/// shines along a facet or has no direction, to the front of the facet. It is moved by some 2^-16
/// of the coordinates there, which is too little to change what it lights. In an edge or corner it
/// is moved farther, until it stands clear of all walls, by 2^-8 of the coordinates at most: that
/// much is needed in an edge of half a degree.
/// @param places Points of the lamp, scene coordinates: its position, or its centre and rim.
/// @param aim Unit length, or zero for a lamp without a direction.
glm::dvec3 WayClearOfFacets(
  const Scene& scene, const std::vector<glm::dvec3>& places, const glm::dvec3& aim);

} // namespace PhotonTransport
