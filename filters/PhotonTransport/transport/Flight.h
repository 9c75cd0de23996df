// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/ColourScattering.h"
#include "PhotonTransport/registration/Registrar.h"
#include "PhotonTransport/sampling/ScatteringSamples.h"

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// A photon on its way. The rays of all photons are kept in an array of their own.
struct Flight
{
  ScatteringNumbers numbers;
  std::uint32_t order; ///< Scatterings so far.
  PhotonOrigin origin;
};

inline PhotonOrigin OriginOf(const Emission& emission)
{
  PhotonOrigin origin;
  origin.source = emission.source;
  origin.shares = emission.shares;
  return origin;
}

/// What becomes of a photon at a facet; see ScatterColours. It takes the colour that this gives it.
template <ScatteringSet Possible>
Departure ScatterPhoton(const Roulette& material, PhotonOrigin& photon,
  const ScatteringSample& sample, const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  const auto [departure, weights] =
    ScatterColours<Possible>(material, photon.shares, sample, direction, normal, front);
  if (!material.grey && !departure.absorbed)
  {
    photon.shares = SharesAfter(photon.shares, weights);
  }
  return departure;
}

/// So many photons are followed together.
constexpr std::size_t PhotonsTogether = ScatteringSamples::Most;

} // namespace PhotonTransport
