// SPDX-License-Identifier: BSD-3-Clause
// Where a lamp is and where the surface is, in the data's length unit.
#ifndef LampPlace_h
#define LampPlace_h

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>

struct Box
{
  glm::dvec3 least;
  glm::dvec3 most;
};

/// Around the triangles. There must be one.
Box BoxOf(const PhotonTransport::Surface& surface);

/// A lamp's point or centre; nothing for light from outside and for the surface's own facets.
std::optional<glm::dvec3> PlaceOf(const PhotonTransport::Lamp& lamp);

/// Farther from the box than this is across.
bool IsFar(const glm::dvec3& place, const Box& box);

/// For a place that is far from the box, a sentence on the unit in which it would be in the box,
/// where there is such a one; or nothing.
std::string HintOnUnits(const glm::dvec3& place, const Box& box);

#endif
