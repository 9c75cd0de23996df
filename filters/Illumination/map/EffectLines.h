// SPDX-License-Identifier: BSD-3-Clause
#ifndef EffectLines_h
#define EffectLines_h

#include "PhotonTransport/effects/Effects.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace Illumination
{

/// The effects in words, one line for each, which begins with the effect's name and says whether it
/// is simulated and why, such as "interreflection: on, 10 of 12 triangles have diffuse
/// reflectance". @param switchedOff [Scattering] The flux that an effect which is switched off
/// would have carried on, lm. @param gatherRays For each point; 0 where there is no second pass.
std::vector<std::string> EffectLines(const PhotonTransport::Effects& effects,
  const std::array<double, PhotonTransport::Scatterings>& switchedOff, std::uint32_t gatherRays);

} // namespace Illumination

#endif
