// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/transport/Walk.h"

#include <cstdint>

namespace PhotonTransport
{

/// The walk that a scene needs. Effects that are switched off count, too: the walk must still find
/// the photons that would have taken that way, and end them.
Walk WalkFor(const Effects& effects);

/// Traces photons [first, last) of a sequence into sums.
using BlockTracer = void (*)(const WalkSettings& settings, float weightBound, std::uint64_t first,
  std::uint64_t last, IlluminationSums& sums);

/// What the walk that is compiled registers.
struct RegistrationChoice
{
  Registration registration;
  bool backSide;
  bool
    cells; ///< Count light by WalkSettings::cells, and register no more than caustics at vertices.
};

/// The function that is compiled for just this walk and this registration.
BlockTracer CompiledWalk(Walk walk, const RegistrationChoice& choice);

} // namespace PhotonTransport
