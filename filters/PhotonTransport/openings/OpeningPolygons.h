// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/Surface.h"

#include <vector>

namespace PhotonTransport
{

/// A polygon that may be an opening. Which side is indoors is not known yet.
struct OpeningPolygon
{
  Opening shape;
  /// How far the pane that it stands for reaches beyond it, along its normal and against it, if the
  /// pane is curved. Scene units.
  float above = 0.0f, below = 0.0f;
};

/// The polygons of holes, of panes and of marked panes, from the largest to the smallest. Panes are
/// divided into flat parts; if these are more than MostOpenings, they are divided into parts that
/// turn by up to 25 degrees, and a convex polygon stands for each that is not flat.
std::vector<OpeningPolygon> OpeningPolygonsOf(const Surface& surface, const Scene& scene);

/// The polygons of panes that are marked as no openings.
std::vector<OpeningPolygon> RefusedPolygonsOf(const Surface& surface, const Scene& scene);

/// Whether light passes straight through a facet.
bool PassesStraightOn(const Surface& surface, std::size_t facet);

} // namespace PhotonTransport
