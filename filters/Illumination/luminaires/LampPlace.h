// SPDX-License-Identifier: BSD-3-Clause
// Where a lamp is and where the surface is, in the data's length unit.
#ifndef LampPlace_h
#define LampPlace_h

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace Illumination
{

struct Box
{
  glm::dvec3 least;
  glm::dvec3 most;
};

/// The bounding box of the triangles, of which there must be at least one.
Box BoxOf(const PhotonTransport::Surface& surface);

/// The position or centre of a lamp, for an emitting mesh the mean of its points; nothing for
/// parallel light, skies and the surface's own facets.
std::optional<glm::dvec3> PlaceOf(const PhotonTransport::Lamp& lamp);

/// For a place that is as far from the box as a lamp would be whose position is in another unit of
/// length, and would be in the box in that unit, a sentence that says so; otherwise empty.
std::string HintOnUnits(const glm::dvec3& place, const Box& box);

} // namespace Illumination

#endif
