// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/EffectSettings.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"

#include <string>
#include <vector>

namespace PhotonTransport
{

/// Which effects a scene calls for, and which of them are simulated. The walk that runs is compiled
/// without most of the effects that no facet and no lamp calls for; see Walk.
struct Effects
{
  /// The registration that runs. It is Flat, whatever was asked for, where every vertex normal is
  /// that of all facets around the vertex: there is nothing to compensate then.
  Registration registration = Registration::VertexNormalised;
  ScatteringSet present = 0;   ///< Ways in which facets scatter light.
  ScatteringSet simulated = 0; ///< Those of them that are switched on.
  bool colour = false;         ///< Photons carry a channel each.
  bool colouredFacets = false; ///< Facets treat the channels unequally, or shine in a colour.
  bool backSide = false;       ///< Hits on the backs of facets are registered.
  /// The answer in words, one line for each effect, such as "interreflection: on, 10 of 12
  /// triangles have diffuse reflectance".
  std::vector<std::string> reasons;
};

/// The name of an effect in Effects::reasons, such as "specular reflection".
std::string EffectName(Scattering scattering);

Effects AnalyseEffects(
  const Scene& scene, const Lighting& lighting, const EffectSettings& settings);

} // namespace PhotonTransport
