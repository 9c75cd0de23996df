// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/registration/PhotonHit.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/statistics/GroupMeans.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <optional>

namespace PhotonTransport
{

/// Bytes that a Surface, its Scene, an IlluminationRun and the maps it gives take together at most,
/// worked out from the Surface before the rest is allocated. This counts what grows with the
/// surface, and not the few MiB that every process takes. @param surface Valid; see Validate.
std::uint64_t MemoryNeed(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings);

/// Bytes more for each vertex if group means are asked for. They are there three times: as the core
/// makes them, by point, and as arrays.
constexpr std::uint64_t GroupMeansPerVertex = 3 * 2 * sizeof(GroupValues);

/// Bytes more for each hit of a photon map: the hit, in a list that grows, and the arrays that a
/// filter makes of it.
constexpr std::uint64_t StoredPhotonNeed = 3 * sizeof(PhotonHit) + 14 * sizeof(double);

/// Bytes that this process can still take without being killed or swapped out, by what Linux and
/// its control groups say; nothing on other systems.
std::optional<std::uint64_t> AvailableMemory();

/// So many facets that a refined surface takes half of the memory. @param limit See RequireMemory.
std::uint64_t MostRefinedFacets(std::uint64_t limit);

/// So many facets of a map that is refined where its light varies fit the memory that is left,
/// about.
/// @param limit See RequireMemory. @param need What the run takes already.
std::uint64_t MostAdaptiveFacets(std::uint64_t limit, std::uint64_t need);

/// Throws InvalidInput that names both numbers if the need is above the limit. @param limit Bytes;
/// 0 is AvailableMemory(), or no limit where that is not known.
void RequireMemory(std::uint64_t need, std::uint64_t limit);

} // namespace PhotonTransport
