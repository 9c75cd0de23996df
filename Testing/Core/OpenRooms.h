// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Surface.h"

#include "Shapes.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

/// Rooms with holes, for tests of openings. All faces have reflectance 0 and points of their own.
namespace OpenRooms
{

using PhotonTransport::Surface;
using Shapes::Edges;

/// A rectangle at `corner` along unit u and v, as long as `lengths`, without `holes`. Its facets
/// share their corners.
Surface Wall(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
  const glm::dvec2& lengths, const std::vector<Edges>& holes = {});

/// The room [0, 4] x [0, 4] x [0, 3] with holes in the wall x = 4, in (y, z).
Surface Room(const std::vector<Edges>& holes);

/// The hole of the daylight room: 1.33 x 1.5 m.
constexpr Edges Window{ 1.335, 0.9, 2.665, 2.4 };

/// A ground of 40 x 40 around the room at a height; whole, or without the room's floor.
Surface Ground(double height, bool whole);

/// A point for each corner of each facet.
Surface WithPointsApart(Surface surface);

/// Every coordinate times `scale`, plus `shift`, rounded to single precision if wanted.
Surface Moved(Surface surface, double scale, const glm::dvec3& shift, bool toSingle);

/// Each facet has the material of index `material`, which is added.
Surface WithMaterial(Surface surface, const PhotonTransport::Material& material);

/// A pane that lets everything through.
PhotonTransport::Material ClearMaterial();

} // namespace OpenRooms
