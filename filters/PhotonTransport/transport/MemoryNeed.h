// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/statistics/GroupMeans.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <optional>

namespace PhotonTransport
{

/// Bytes that a Surface, its Scene, an IlluminationRun and the maps it gives take together at most,
/// told before any of it is allocated. Counts what grows with the surface; a few MiB that every
/// process takes are not in it.
std::uint64_t MemoryNeed(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings);

/// Bytes more for each vertex where group means are asked for: as the core makes them, by point,
/// and as arrays.
constexpr std::uint64_t GroupMeansPerVertex = 3 * 2 * sizeof(GroupValues);

/// Bytes that this process could still take without being killed or swapped out, as Linux and its
/// control groups tell; nothing on other systems.
std::optional<std::uint64_t> AvailableMemory();

/// Throws InvalidInput that says need and limit. @param limit Bytes; 0 is AvailableMemory().
void RequireMemory(std::uint64_t need, std::uint64_t limit);

} // namespace PhotonTransport
