// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <vector>

namespace PhotonTransport
{

/// An estimate of the error of facet size (lx, >= 0) at each vertex: how far the light that is
/// registered at a vertex, a mean over the facets around it, is from the light at the vertex
/// itself. It is largest at borders (the edges of a room), beside lamps and at shadows.
///
/// The estimate undoes the mean (the L2 projection onto linear elements) and takes the difference,
/// by factors that were measured against the light at single points. It uses the map and its
/// geometry only. Its root mean square over a wall, a floor or a body is within a factor of two of
/// the true one where that exceeds the noise; single values are less certain. It can't see what no
/// neighbour shows, such as a constant error from chords that lie nearer to a lamp than the
/// surface they stand for. Noise of the map is subtracted; with too few photons, 0.2 to 0.8 times
/// the standard error is left of it.
///
/// @param illuminance [vertex] lx, of one side. @param standardError Its, lx.
/// @param compensated Whether registration compensated the tilt of facets against vertex normals.
/// The result has the same bits for any number of threads.
std::vector<double> FacetError(const Scene& scene, std::vector<double> illuminance,
  const std::vector<double>& standardError, bool compensated);

} // namespace PhotonTransport
