// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/FiltrationMonitor.h"
#include "PhotonTransport/filtration/SmoothingGraph.h"
#include "PhotonTransport/statistics/GroupMeans.h"

#include <cstddef>
#include <string>
#include <vector>

namespace PhotonTransport
{

enum class FiltrationMethod : int
{
  None = 0,      ///< The map as it is.
  Diffusion = 1, ///< A heat kernel of one width everywhere, for comparison.
  Adaptive = 2   ///< A width for each vertex, as the noise there asks for.
};

struct FiltrationSettings
{
  FiltrationMethod method = FiltrationMethod::Adaptive;
  double strength = 1.0; ///< Adaptive: 1 is the estimated optimum, [0, 10].
  double width = 4.0;    ///< Diffusion: standard deviation in vertex distances, [0, 50].
  int threads = 0;       ///< For Threads, [0, MostThreads]; 0: all there are.
};

/// Throws InvalidInput that names the setting.
void Validate(const FiltrationSettings& settings);

/// A part of the light (direct, indirect, or all of it) and what is known of its noise.
struct NoisyMap
{
  std::string name;                  ///< For messages, such as "IlluminanceDirect".
  std::vector<double> values;        ///< [vertex] lx, finite, >= 0.
  std::vector<GroupValues> groups;   ///< [vertex] See GroupMeans; or empty.
  std::vector<double> standardError; ///< [vertex] lx, finite, >= 0; or empty. Used without groups.
};

struct FilteredMap
{
  std::vector<double> values; ///< lx, >= 0; sum(A E) of each smooth patch is that of the input.
  std::vector<double> squaredError; ///< lx^2, of noise and bias.
  std::vector<float> width; ///< Of the kernel, in vertex distances; 0 where it is as it was.
};

/// Smooths the parts of one illumination map (B. Barladian, "Indirect illumination on curve
/// surfaces", "filtration") across the smooth patches of its surface. A part that is certainly
/// zero in places (see FindDarkRegions) stays so there. The time is linear in the vertices, and
/// the result has the same bits for any number of threads.
/// Throws InvalidInput for settings or values out of range. @param hits [vertex] Photons on the
/// facets around, of all parts together; or empty. @param monitor Told the share of all the work.
std::vector<FilteredMap> Filtrate(const SmoothingGraph& graph, const std::vector<NoisyMap>& parts,
  const std::vector<double>& hits, const FiltrationSettings& settings,
  const FiltrationMonitor& monitor);

} // namespace PhotonTransport
