// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/registration/Registration.h"

#include <string>
#include <vector>

namespace PhotonTransport
{

struct TraceSettings;

/// Which effects a scene calls for, and which of them are simulated. What no facet and no lamp
/// calls for is not in the walk that is run.
struct Effects
{
  /// Flat where all rings are, whatever was asked for: there is nothing to compensate.
  Registration registration = Registration::VertexNormalised;
  ScatteringSet present = 0;   ///< Ways in which facets scatter light.
  ScatteringSet simulated = 0; ///< Those of them that are switched on.
  bool colour = false;         ///< Photons carry a channel each.
  bool colouredFacets = false; ///< And facets tell them apart.
  bool backSide = false;
  /// The answer in words, an effect a line: "interreflection: on, 10 of 12 triangles have diffuse
  /// reflectance".
  std::vector<std::string> reasons;
};

/// "specular reflection" and so on.
std::string EffectName(Scattering scattering);

Effects AnalyseEffects(const Scene& scene, const Lighting& lighting, const TraceSettings& settings);

} // namespace PhotonTransport
