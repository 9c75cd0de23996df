// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>

namespace PhotonTransport
{

/// Bytes.
struct GatheringNeed
{
  std::uint64_t stays = 0;
  std::uint64_t whileTracing = 0; ///< In addition, in sums that threads give up afterwards.
};

/// What Method::FinalGathering takes beyond what Method::PhotonTracing does: what counts photons by
/// cells, the exitance of the cells and the maps of the second pass; nothing in the latter. See
/// MemoryNeed. @param colour Whether photons have colours.
GatheringNeed GatheringMemory(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings, bool colour);

} // namespace PhotonTransport
