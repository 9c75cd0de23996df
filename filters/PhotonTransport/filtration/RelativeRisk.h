// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/CandidateMaps.h"
#include "PhotonTransport/filtration/PhotonNoise.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Which candidates each vertex may have, a bit for each; at least one.
using Admission = std::vector<std::uint16_t>;

inline bool Admits(const Admission& admission, std::size_t candidate, std::size_t v)
{
  return (admission[v] >> candidate & 1u) != 0;
}

/// Admits the candidates whose expected squared error, weighed by the light at the vertex to the
/// power -3/2, is near the least. A width that is right in lx^2 for bright vertices, since it saves
/// much of their noise, can bring the dim ones among them many times their own light; the weight
/// shows that.
/// @param strength See SelectionSettings.
Admission AdmitByRelativeRisk(const SmoothingGraph& graph, const CandidateMaps& candidates,
  const PhotonNoise& photons, double strength, const FiltrationMonitor& monitor);

} // namespace PhotonTransport
