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
    for (std::size_t i = 0; i < count; ++i)
    {
      const Emission emission = source.Emit(this->emitted[i]);
      this->rays[this->flying] = emission.ray;
      this->photons[this->flying++] = { this->emitted[i].Scatterings(), 0, OriginOf(emission) };
      ++balances[emission.source].emitted;
    }
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
