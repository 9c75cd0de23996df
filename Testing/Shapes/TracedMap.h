// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/IlluminationRun.h"

/// A whole run to a number of photons, for tests.
struct TracedMap
{
  TracedMap(const PhotonTransport::Scene& scene, const PhotonTransport::Lamp& lamp,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons)
  {
    PhotonTransport::IlluminationRun run(scene, lamp, settings);
    run.Advance({ photons });
    this->front = run.Front();
    this->back = settings.registerBackSide ? run.Back() : PhotonTransport::IlluminationMap();
    this->balance = run.Balance();
  }

  PhotonTransport::IlluminationMap front;
  PhotonTransport::IlluminationMap back;
  PhotonTransport::PhotonBalance balance;
};
