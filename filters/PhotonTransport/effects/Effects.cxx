// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/effects/Effects.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

bool ShinesInColour(const Luminaire& luminaire)
{
  return !IsGrey(luminaire.colour);
}

EffectCounts CountsOf(const Scene& scene, const Lighting& lighting)
{
  EffectCounts counts;
  counts.vertices = scene.NumberOfMapVertices();
  counts.tiltedVertices = scene.Notes().tiltedVertices;
  counts.facets = scene.NumberOfGivenFacets();
  counts.curvedFacets = scene.Notes().curvedFacets;
  counts.parts = scene.Notes().curvedFacets + scene.Facets().size() - counts.facets;
  counts.turn = scene.Notes().turn;
  counts.isCoarse = scene.Notes().isCoarse;
  counts.scatteringFacets = scene.Notes().scatteringFacets;
  counts.colouredFacets = scene.Notes().colouredFacets;
  counts.lamps = lighting.luminaires.size();
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    counts.colouredLamps += ShinesInColour(luminaire);
    const LampClass lampClass = ClassOf(luminaire.lamp);
    counts.areaLamps += lampClass == LampClass::Area;
    counts.photometricLamps += lampClass == LampClass::Photometric;
    counts.skies += lampClass == LampClass::Sky;
  }
  return counts;
}

} // namespace

Effects AnalyseEffects(const Scene& scene, const Lighting& lighting, const EffectSettings& settings)
{
  Effects effects;
  effects.settings = settings;
  effects.counts = CountsOf(scene, lighting);
  effects.registration =
    effects.counts.tiltedVertices > 0 ? settings.registration : Registration::Flat;
  for (unsigned s = 0; s < Scatterings; ++s)
  {
    effects.present |= effects.counts.scatteringFacets[s] > 0 ? 1u << s : 0u;
  }
  effects.simulated = effects.present & settings.scatterings;
  effects.colouredFacets = settings.colour && effects.counts.colouredFacets > 0;
  effects.colour = SimulatesColour(effects.colouredFacets, lighting, settings);
  return effects;
}

bool SimulatesColour(bool facets, const Lighting& lighting, const EffectSettings& settings)
{
  return settings.colour &&
    (facets || std::any_of(lighting.luminaires.begin(), lighting.luminaires.end(), ShinesInColour));
}

} // namespace PhotonTransport
