// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/Registrar.h"
#include "PhotonTransport/sampling/PhotonSample.h"

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

/// So many photons are followed together.
constexpr std::size_t PhotonsTogether = 64;

} // namespace PhotonTransport
