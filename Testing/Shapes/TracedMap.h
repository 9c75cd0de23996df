// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/IlluminationRun.h"

/// How many facets a hit registers on at most: 1, unless some lie in one place and face the same
/// way.
inline std::size_t MostFacetsInOnePlace(const PhotonTransport::Scene& scene)
{
  const PhotonTransport::SharedPlaceNotes& shared = scene.Notes().sharedPlaces;
  return shared.copies.facets + shared.inPart.facets > 0 ? scene.Facets().size() : 1;
}

/// A whole run to a number of photons, for tests.
struct TracedMap
{
  TracedMap(const PhotonTransport::Scene& scene, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons)
  {
    PhotonTransport::IlluminationRun run(scene, lighting, settings);
    run.Advance({ photons });
    this->front = run.Front();
    this->back = settings.registerBackSide ? run.Back() : PhotonTransport::IlluminationMap();
    this->balance = run.Balance();
  }

  PhotonTransport::IlluminationMap front;
  PhotonTransport::IlluminationMap back;
  PhotonTransport::PhotonBalance balance;
};
