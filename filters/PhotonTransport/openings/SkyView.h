// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>

namespace PhotonTransport
{

/// So many rays look for the sky from either side of a polygon.
constexpr std::size_t SkyRays = 256;

/// How much sky a polygon sees.
struct SkyView
{
  std::size_t front = 0;   ///< How many of SkyRays, on the side of the polygon's normal.
  std::size_t back = 0;    ///< On the other side.
  std::size_t covered = 0; ///< How many of the rays' starting points lie on an opaque facet.
};

/// Sends cosine-distributed rays from points all over the polygon, which pass through panes
/// straight on. The same for any number of threads.
/// @param isSky See FindOpenings.
SkyView ViewOfSky(
  const Opening& polygon, const Scene& scene, const std::function<bool(const glm::vec3&)>& isSky);

} // namespace PhotonTransport
