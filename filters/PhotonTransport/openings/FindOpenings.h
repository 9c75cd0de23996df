// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/SceneNotes.h"
#include "PhotonTransport/scene/Surface.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>

namespace PhotonTransport
{

/// What became of polygons that were found and are no openings. They are looked at from the largest
/// to the smallest.
struct OpeningNotes
{
  std::size_t openToBothSides = 0; ///< As much sky is seen from either side, up to a factor of 2.
  std::size_t withoutSky = 0;      ///< Hardly any sky is seen from either side.
  std::size_t covered = 0;         ///< Other facets lie in the hole.
  std::size_t doubled = 0;         ///< A larger opening lies close in front or behind.
  std::size_t tooMany = 0;         ///< Smaller than the MostOpenings that were kept, not looked at.
  Finding opaqueMarks; ///< Facets that are marked as openings and let no light straight through.
};

struct FoundOpenings
{
  Openings openings; ///< From the largest to the smallest.
  OpeningNotes notes;
};

/// Finds the openings of a surface, see OpeningMark:
/// - holes, whose border is a flat loop (FindFlatLoops), unless a facet at it is marked as none, or
/// a
///   pane in it;
/// - facets with clear transmittance that are no surface of a solid body, together where they hang
///   together in a plane, unless they are marked as none. A few convex polygons stand for a curved
///   pane, just outside of it.
/// Indoors is the side from which less sky is seen, by 256 cosine-distributed rays from either
/// side, which pass through panes.
/// @param surface What the scene was made of.
/// @param isSky Whether light comes from far away in a direction (unit, away from the scene). Must
/// not change from call to call. Empty: all that leaves the scene sees the sky.
FoundOpenings FindOpenings(const Surface& surface, const Scene& scene,
  const std::function<bool(const glm::vec3&)>& isSky = {});

} // namespace PhotonTransport
