// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/statistics/PhotonBalance.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace PhotonTransport
{

/// Illuminance at the vertices of one side, lx.
struct SideMap
{
  std::vector<double> direct;            ///< Straight from the lamp.
  std::vector<double> indirect;          ///< After at least one reflection.
  std::vector<double> standardError;     ///< Of direct + indirect; covers noise, not facet size.
  std::vector<std::uint64_t> photonHits; ///< On this side of the facets around the vertex.
};

/// The result of a run. Vectors have one value a vertex; 0 at a vertex without a facet.
struct IlluminationMap
{
  SideMap front;
  SideMap back; ///< Empty unless asked for.
  PhotonBalance balance;
  double flux = 0.0;                 ///< Of the photons, lm.
  double fluxCutByWeightBound = 0.0; ///< lm
  double seconds = 0.0;              ///< Spent tracing.
  bool complete = false;             ///< False if the monitor ended it; the map is valid still.
  std::vector<std::string> effects;  ///< Which are on or off, and why.
};

/// Called with the traced share of the photons, in [0, 1], from the calling thread; returns false
/// to stop.
using ProgressMonitor = std::function<bool(double fraction)>;

/// Traces the map. Throws InvalidInput for a lamp or settings that make no sense.
IlluminationMap TraceIlluminationMap(const Scene& scene, const Lamp& lamp,
  const TraceSettings& settings, const ProgressMonitor& monitor = {});

} // namespace PhotonTransport
