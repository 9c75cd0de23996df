// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/effects/Effects.h"

namespace PhotonTransport
{
namespace
{

/// Counts a lamp by its kind.
struct CountKind
{
  EffectCounts& counts;
  void operator()(const RectangleLamp&) const { ++this->counts.areaLamps; }
  void operator()(const DiskLamp&) const { ++this->counts.areaLamps; }
  void operator()(const SphereLamp&) const { ++this->counts.areaLamps; }
  void operator()(const LineLamp&) const { ++this->counts.areaLamps; }
  void operator()(const EmittingFacets&) const { ++this->counts.areaLamps; }
  void operator()(const EmittingMesh&) const { ++this->counts.areaLamps; }
  void operator()(const PhotometricLamp&) const { ++this->counts.photometricLamps; }
  void operator()(const UniformSky&) const { ++this->counts.skies; }
  void operator()(const CieSky&) const { ++this->counts.skies; }
  template <typename Other>
  void operator()(const Other&) const
  {
  }
};

EffectCounts CountsOf(const Scene& scene, const Lighting& lighting)
{
  EffectCounts counts;
  counts.vertices = scene.Vertices().size();
  counts.tiltedVertices = scene.Notes().tiltedVertices;
  counts.facets = scene.Facets().size();
  counts.scatteringFacets = scene.Notes().scatteringFacets;
  counts.colouredFacets = scene.Notes().colouredFacets;
  counts.lamps = lighting.luminaires.size();
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    counts.colouredLamps += !IsGrey(luminaire.colour);
    std::visit(CountKind{ counts }, luminaire.lamp);
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
  effects.colour = effects.colouredFacets || (settings.colour && effects.counts.colouredLamps > 0);
  return effects;
}

} // namespace PhotonTransport
