// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>

namespace PhotonTransport
{

/// Bytes by the phases of a run: while photons are traced, then while the second pass gathers, then
/// while maps are made.
struct PhaseBytes
{
  std::uint64_t always = 0;
  std::uint64_t tracing = 0; ///< In addition, as all that follows.
  std::uint64_t gathering = 0;
  std::uint64_t maps = 0;
};

/// What Method::FinalGathering takes beyond what Method::PhotonTracing does: what counts photons by
/// cells, the exitance of the cells and the maps of the second pass; nothing in the latter.
struct GatheringNeed
{
  PhaseBytes whole;   ///< Whatever the number of cells.
  PhaseBytes perCell; ///< Both sides.
};

/// See MemoryNeed. @param colour Whether photons have colours.
GatheringNeed GatheringMemory(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings, bool colour);

} // namespace PhotonTransport
