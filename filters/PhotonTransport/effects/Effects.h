// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/EffectSettings.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// How much of a scene calls for each effect.
struct EffectCounts
{
  std::size_t vertices = 0;
  std::size_t tiltedVertices = 0; ///< Their normal differs from that of a facet around them.
  std::size_t facets = 0;
  std::size_t curvedFacets = 0;                            ///< They are traced as curved patches.
  std::size_t parts = 0;                                   ///< Of the curved facets.
  double turn = 0.0;                                       ///< See GivenSurface.
  bool isCoarse = false;                                   ///< See GivenSurface.
  std::array<std::size_t, Scatterings> scatteringFacets{}; ///< [Scattering]
  std::size_t colouredFacets = 0; ///< They treat the channels unequally, or shine in a colour.
  std::size_t lamps = 0;
  std::size_t colouredLamps = 0;
  std::size_t areaLamps = 0; ///< They shine from an area or a line.
  std::size_t photometricLamps = 0;
  std::size_t skies = 0;
};

/// Which effects a scene calls for, and which of them are simulated. The walk that runs is compiled
/// without most of the effects that no facet and no lamp calls for; see Walk.
struct Effects
{
  /// The registration that runs. It is Flat, whatever was asked for, where every vertex normal is
  /// that of all facets around the vertex: there is nothing to compensate then.
  Registration registration = Registration::VertexNormalised;
  ScatteringSet present = 0;   ///< Ways in which facets scatter light.
  ScatteringSet simulated = 0; ///< Those of them that are switched on.
  bool colour = false;         ///< Photons have colours.
  bool colouredFacets = false; ///< Facets treat the channels unequally, and this is simulated.
  EffectSettings settings;     ///< What was asked for.
  EffectCounts counts;
};

Effects AnalyseEffects(
  const Scene& scene, const Lighting& lighting, const EffectSettings& settings);

/// Whether photons have colours, and these are therefore kept apart in the map.
/// @param facets Whether a facet IsColoured.
bool SimulatesColour(bool facets, const Lighting& lighting, const EffectSettings& settings);

} // namespace PhotonTransport
