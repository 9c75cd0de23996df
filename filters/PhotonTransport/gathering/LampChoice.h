// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LightSampler.h"
#include "PhotonTransport/gathering/Receiver.h"

#include <cstdint>

namespace PhotonTransport
{

/// One sample, without bias, of the light of all lamps but skies at a receiver, by channel.
/// @param number In [0, 1). @param lamp Gets the lamp that was chosen.
Colour SampleOfAllLamps(
  const LightSampler& sampler, const Receiver& receiver, double number, std::uint32_t& lamp);

} // namespace PhotonTransport
