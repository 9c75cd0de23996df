// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/effects/Effects.h"

#include <algorithm>
#include <sstream>

namespace PhotonTransport
{
namespace
{

struct Words
{
  const char* effect;
  const char* property; ///< What a facet that calls for it has.
};

constexpr Words WordsOf[Scatterings] = { { "interreflection", "diffuse reflectance" },
  { "specular reflection", "specular reflectance" }, { "glossy reflection", "glossy reflectance" },
  { "diffuse transmission", "diffuse transmittance" },
  { "clear transmission", "clear transmittance as a pane" },
  { "refraction", "clear transmittance as the surface of a solid body" } };

template <typename... Parts>
std::string Line(const Parts&... parts)
{
  std::ostringstream line;
  (line << ... << parts);
  return line.str();
}

std::string CompensationReason(const Scene& scene, Registration registration)
{
  if (registration == Registration::Flat)
  {
    return "compensation: off, flat registration was chosen";
  }
  const std::size_t tilted = scene.Notes().tiltedVertices;
  return tilted == 0 ? "compensation: off, all points have the normal of all facets around them"
                     : Line("compensation: on, ", tilted, " of ", scene.Vertices().size(),
                         " points have a normal that differs from a facet's around them");
}

std::string ScatteringReason(const Scene& scene, Scattering scattering, ScatteringSet switchedOn)
{
  const Words& words = WordsOf[static_cast<unsigned>(scattering)];
  const std::size_t facets = scene.Notes().scatteringFacets[static_cast<unsigned>(scattering)];
  if (facets == 0)
  {
    return Line(words.effect, ": off, no triangle has ", words.property);
  }
  const std::string share =
    Line(facets, " of ", scene.Facets().size(), " triangles have ", words.property);
  return (switchedOn & SetOf(scattering)) != 0
    ? Line(words.effect, ": on, ", share)
    : Line(words.effect, ": off, switched off though ", share,
        "; the photons it would have carried on are counted as cut off");
}

std::size_t ColouredLamps(const Lighting& lighting)
{
  return static_cast<std::size_t>(
    std::count_if(lighting.luminaires.begin(), lighting.luminaires.end(),
      [](const Luminaire& luminaire) { return !IsGrey(luminaire.colour); }));
}

std::string ColourReason(const Scene& scene, const Lighting& lighting, bool switchedOn)
{
  const std::size_t lamps = ColouredLamps(lighting);
  const std::size_t facets = scene.Notes().colouredFacets;
  if (lamps + facets == 0)
  {
    return "colour: off, no triangle and no lamp treats red, green and blue unequally";
  }
  const std::string share = Line(facets, " of ", scene.Facets().size(), " triangles and ", lamps,
    lamps == 1 ? " lamp have a colour" : " lamps have a colour");
  return switchedOn ? "colour: on, " + share : "colour: off, switched off though " + share;
}

struct LampCounts
{
  std::size_t area = 0, photometric = 0, sky = 0;
  void operator()(const RectangleLamp&) { ++this->area; }
  void operator()(const DiskLamp&) { ++this->area; }
  void operator()(const SphereLamp&) { ++this->area; }
  void operator()(const LineLamp&) { ++this->area; }
  void operator()(const EmittingFacets&) { ++this->area; }
  void operator()(const EmittingMesh&) { ++this->area; }
  void operator()(const PhotometricLamp&) { ++this->photometric; }
  void operator()(const UniformSky&) { ++this->sky; }
  void operator()(const CieSky&) { ++this->sky; }
  template <typename Other>
  void operator()(const Other&)
  {
  }
};

std::vector<std::string> LampReasons(const Lighting& lighting)
{
  LampCounts counts;
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    std::visit([&](const auto& lamp) { counts(lamp); }, luminaire.lamp);
  }
  const std::size_t lamps = lighting.luminaires.size();
  const auto line = [&](const char* effect, std::size_t count, const char* what)
  {
    return count > 0 ? Line(effect, ": on, ", count, " of ", lamps, " lamps")
                     : Line(effect, ": off, none of ", lamps, " lamps ", what);
  };
  return { line("area lamps", counts.area, "shines from an area or a line"),
    line("photometric lamps", counts.photometric, "has the intensities of a photometric file"),
    line("sky", counts.sky, "is a sky"),
    line("choice between lamps", lamps > 1 ? lamps : 0, "is one of several") };
}

} // namespace

std::string EffectName(Scattering scattering)
{
  return WordsOf[static_cast<unsigned>(scattering)].effect;
}

Effects AnalyseEffects(const Scene& scene, const Lighting& lighting, const EffectSettings& settings)
{
  Effects effects;
  effects.registration =
    scene.Notes().tiltedVertices > 0 ? settings.registration : Registration::Flat;
  effects.reasons.push_back(CompensationReason(scene, settings.registration));
  for (unsigned s = 0; s < Scatterings; ++s)
  {
    effects.present |= scene.Notes().scatteringFacets[s] > 0 ? 1u << s : 0u;
    effects.reasons.push_back(
      ScatteringReason(scene, static_cast<Scattering>(s), settings.scatterings));
  }
  effects.simulated = effects.present & settings.scatterings;
  effects.colouredFacets = settings.colour && scene.Notes().colouredFacets > 0;
  effects.colour = effects.colouredFacets || (settings.colour && ColouredLamps(lighting) > 0);
  effects.reasons.push_back(ColourReason(scene, lighting, settings.colour));
  for (const std::string& line : LampReasons(lighting))
  {
    effects.reasons.push_back(line);
  }
  effects.backSide = settings.registerBackSide;
  effects.reasons.push_back(settings.registerBackSide
      ? "back side: on, its registration was asked for"
      : "back side: off, its registration was not asked for");
  return effects;
}

} // namespace PhotonTransport
