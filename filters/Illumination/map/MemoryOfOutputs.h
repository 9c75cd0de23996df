// SPDX-License-Identifier: BSD-3-Clause
#ifndef MemoryOfOutputs_h
#define MemoryOfOutputs_h

#include "PhotonTransport/transport/MemoryBudget.h"

#include <cstdint>

namespace Illumination
{

/// What a user wants of a run that its settings do not tell.
struct WantedOutputs
{
  bool groupMeans;
  std::uint64_t photons; ///< Hits of a photon map, at most.
};

/// Bytes that the filter takes beside a run: which points and cells vertices and facets come from,
/// the given surface where another one is traced, and what it makes of the maps.
/// @param surface That is traced. @param colours Whether there are.
PhotonTransport::MemoryBeside MemoryOfOutputs(const PhotonTransport::Surface& surface,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  bool colours, const WantedOutputs& wanted);

} // namespace Illumination

#endif
