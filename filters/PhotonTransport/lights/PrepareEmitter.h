// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/EmitterKinds.h"
#include "PhotonTransport/lights/Lamp.h"

namespace PhotonTransport
{

/// A lamp made ready, and its luminous flux, lm. For light from outside the flux is what enters the
/// disk or ball from which photons start.
struct PreparedEmitter
{
  EmitterKind source;
  double flux;
};

/// Throws InvalidInput for a lamp that makes no sense (names the value).
/// @param scene Must outlive the result.
PreparedEmitter PrepareEmitter(const Lamp& lamp, const Scene& scene);

} // namespace PhotonTransport
