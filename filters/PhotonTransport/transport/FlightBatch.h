// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/DiffuseReflections.h"
#include "PhotonTransport/registration/PhotonBalance.h"
#include "PhotonTransport/sampling/ScatteringSamples.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/transport/Flight.h"

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// Photons that are followed together.
struct FlightBatch
{
  explicit FlightBatch(const SequenceKey& key)
    : samples(key)
  {
  }

  /// Adds the next photons of a sequence. @param balances By source.
  void Emit(
    const Emitter& source, PhotonSequence& sequence, std::size_t count, PhotonBalance* balances)
  {
    sequence.Take(this->emitted.data(), count);
    const std::size_t first = this->flying;
    this->flying += count;
    source.Emit(this->emitted.data(), count, this->rays.data() + first,
      [&](std::size_t i, std::uint32_t ofSource, const Colour& shares)
      {
        Flight& photon = this->photons[first + i];
        photon.numbers = this->emitted[i].Scatterings();
        photon.order = 0;
        photon.origin.source = ofSource;
        photon.origin.direct = true;
        photon.origin.undiffused = true;
        photon.origin.arrived = false;
        photon.origin.shares = shares;
        ++balances[ofSource].emitted;
      });
  }

  std::size_t flying = 0;
  std::array<Flight, PhotonsTogether> photons;
  std::array<Ray, PhotonsTogether> rays;
  std::array<Hit, PhotonsTogether> hits;
  std::array<PhotonSample, PhotonsTogether> emitted; ///< What photons start with.
  ScatteringSamples samples;
  DiffuseReflections diffuse;
};

} // namespace PhotonTransport
