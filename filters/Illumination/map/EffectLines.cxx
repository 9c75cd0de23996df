// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/EffectLines.h"

#include "Illumination/pipeline/Text.h"

#include <glm/trigonometric.hpp>

#include <iterator>

namespace Illumination
{
namespace
{

using PhotonTransport::EffectCounts;
using PhotonTransport::Effects;
using PhotonTransport::Scatterings;

struct Words
{
  const char* effect;
  const char* property; ///< What a triangle that calls for it has.
};

/// [Scattering]
constexpr Words WordsOf[] = { { "interreflection", "diffuse reflectance" },
  { "specular reflection", "specular reflectance" }, { "glossy reflection", "glossy reflectance" },
  { "diffuse transmission", "diffuse transmittance" },
  { "clear transmission", "clear transmittance as a pane" },
  { "refraction", "clear transmittance as the surface of a solid body" } };
static_assert(std::size(WordsOf) == Scatterings, "each way of scattering has its words");

std::string CompensationLine(const Effects& effects, bool gathering)
{
  const EffectCounts& counts = effects.counts;
  if (effects.settings.registration == PhotonTransport::Registration::Flat)
  {
    return "compensation: off, flat registration was chosen";
  }
  return counts.tiltedVertices == 0
    ? "compensation: off, all points have the normal of all facets around them"
    : Text("compensation: on, ", counts.tiltedVertices, " of ", counts.vertices,
        " points have a normal that differs from a facet's around them",
        gathering ? "; with final gathering it concerns caustics alone" : "");
}

std::string GatheringLine(const Effects& effects, std::uint32_t rays)
{
  return rays == 0
    ? "final gathering: off, Method is Photon Tracing"
    : Text("final gathering: on, about ", rays, " rays for each of ", effects.counts.vertices,
        effects.settings.registerBackSide ? " points and each side, as Method asks for"
                                          : " points, as Method asks for");
}

std::string CurvedLine(const Effects& effects)
{
  const EffectCounts& counts = effects.counts;
  if (!effects.settings.curvedSurface)
  {
    return "curved surface: off, it was not asked for, and triangles are traced flat as they are";
  }
  if (counts.curvedFacets == 0)
  {
    return counts.isCoarse
      ? "curved surface: off, though triangles are curved: there is no memory for their parts"
      : "curved surface: off, no triangle's normals turn by more than 7 degrees along an edge";
  }
  return Text("curved surface: on, ", counts.curvedFacets, " of ", counts.facets,
    " triangles are traced as ", counts.parts,
    " parts of curved patches, of which the normal turns by about ", glm::degrees(counts.turn),
    " degrees at most along an edge", counts.isCoarse ? "; there is no memory for more" : "");
}

std::string ScatteringLine(const Effects& effects, unsigned scattering, double switchedOff)
{
  const Words& words = WordsOf[scattering];
  const std::size_t facets = effects.counts.scatteringFacets[scattering];
  if (facets == 0)
  {
    return Text(words.effect, ": off, no triangle has ", words.property);
  }
  const std::string share =
    Text(facets, " of ", effects.counts.facets, " triangles have ", words.property);
  if (((effects.simulated >> scattering) & 1u) != 0)
  {
    return Text(words.effect, ": on, ", share);
  }
  return Text(words.effect, ": off, switched off though ", share,
    "; the photons it would have carried on are counted as cut off",
    switchedOff > 0.0 ? Text(", ", switchedOff, " lm") : "");
}

std::string ColourLine(const Effects& effects)
{
  const std::size_t lamps = effects.counts.colouredLamps;
  const std::size_t facets = effects.counts.colouredFacets;
  if (lamps + facets == 0)
  {
    return "colour: off, no triangle and no lamp treats red, green and blue unequally";
  }
  return Text("colour: ", effects.colour ? "on, " : "off, switched off though ", facets, " of ",
    effects.counts.facets, " triangles and ", lamps,
    lamps == 1 ? " lamp have a colour" : " lamps have a colour");
}

std::string LampLine(const char* effect, std::size_t count, std::size_t lamps, const char* what)
{
  return count > 0 ? Text(effect, ": on, ", count, " of ", lamps, " lamps")
                   : Text(effect, ": off, none of ", lamps, " lamps ", what);
}

} // namespace

std::vector<std::string> EffectLines(const Effects& effects,
  const std::array<double, Scatterings>& switchedOff, std::uint32_t gatherRays)
{
  std::vector<std::string> lines{ GatheringLine(effects, gatherRays),
    CompensationLine(effects, gatherRays > 0), CurvedLine(effects) };
  for (unsigned s = 0; s < Scatterings; ++s)
  {
    lines.push_back(ScatteringLine(effects, s, switchedOff[s]));
  }
  lines.push_back(ColourLine(effects));
  const EffectCounts& counts = effects.counts;
  const std::size_t lamps = counts.lamps;
  lines.push_back(LampLine("area lamps", counts.areaLamps, lamps, "shines from an area or a line"));
  lines.push_back(LampLine("photometric lamps", counts.photometricLamps, lamps,
    "has the intensities of a photometric file"));
  lines.push_back(LampLine("sky", counts.skies, lamps, "is a sky"));
  lines.push_back(
    LampLine("choice between lamps", lamps > 1 ? lamps : 0, lamps, "is one of several"));
  lines.push_back(effects.settings.registerBackSide
      ? "back side: on, its registration was asked for"
      : "back side: off, its registration was not asked for");
  return lines;
}

} // namespace Illumination
