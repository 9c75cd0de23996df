// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/GroupStatistics.h"
#include "PhotonTransport/filtration/PhotonNoise.h"

#include <vector>

namespace PhotonTransport
{

/// A map smoothed with a width of its own at each vertex.
struct Selection
{
  GroupColumns groups;
  std::vector<double> change; ///< Mean of `groups` less that of the unsmoothed map, lx.
  std::vector<float> width;   ///< Standard deviation of the kernel chosen, in vertex distances.
};

/// What the choice of widths goes by.
struct SelectionSettings
{
  std::vector<float> importance; ///< [vertex] Weight of a squared error, > 0.
  double strength = 1.0;         ///< 1 is the estimated optimum; 0 keeps the map, 2 smooths more.
};

/// Smooths by twiced heat kernels of eight widths from 1 to 11 vertex distances and chooses among
/// them and the map itself, vertex by vertex, the one with the least mean squared error. That error
/// is estimated without knowing the true map (Stein's unbiased risk estimate, 1981), from the
/// covariances of the groups: |C - X|^2 + 2 cov(C, X) - var X for a candidate C of the map X.
/// Widths that RelativeRisk does not admit at a vertex are not chosen there.
Selection SelectWidths(const SmoothingGraph& graph, const GroupColumns& map,
  const PhotonNoise& photons, const SelectionSettings& settings, const FiltrationMonitor& monitor);

} // namespace PhotonTransport
