// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReferenceScenes.h"

#include <cstdint>
#include <vector>

/// How a map is made.
struct MapSettings
{
  std::uint64_t photons = 1'000'000;
  std::uint32_t seed = 1;
  int threads = 2;
  bool smoothed = false;
  bool gathered = false;  ///< By the second pass.
  bool openings = false;  ///< The run is told of openings.
  std::uint32_t rays = 0; ///< See TraceSettings::gatherRays.
};

/// A map of the fronts of all vertices, and what it took.
struct MeasuredMap
{
  std::vector<double> lux;
  std::vector<double> standardError; ///< lx, as told.
  double seconds = 0.0;              ///< From the surface to the map.
  double secondsOfScene = 0.0;       ///< Of these, until the scene was ready.
};

/// The one place where the benchmark makes a map.
MeasuredMap MakeMap(const ReferenceScene& what, const MapSettings& settings);
