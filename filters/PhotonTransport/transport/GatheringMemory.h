// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>

namespace PhotonTransport
{

/// Bytes that Method::FinalGathering takes beyond what Method::PhotonTracing does: what counts
/// photons by cells, the exitance of the cells and the maps of the second pass; 0 in the latter.
/// See MemoryNeed. @param colour Whether photons have colours.
std::uint64_t GatheringMemory(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings, bool colour);

} // namespace PhotonTransport
