// SPDX-License-Identifier: BSD-3-Clause
#ifndef EffectLines_h
#define EffectLines_h

#include "PhotonTransport/effects/Effects.h"

#include <array>
#include <string>
#include <vector>

namespace Illumination
{

/// The effects in words, one line for each, which begins with the effect's name and says whether it
/// is simulated and why, such as "interreflection: on, 10 of 12 triangles have diffuse
/// reflectance". @param switchedOff [Scattering] The flux that an effect which is switched off
/// would have carried on, lm.
std::vector<std::string> EffectLines(const PhotonTransport::Effects& effects,
  const std::array<double, PhotonTransport::Scatterings>& switchedOff);

} // namespace Illumination

#endif
