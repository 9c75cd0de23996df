// SPDX-License-Identifier: BSD-3-Clause
// What a scene calls for, and the words for it.
#include "Illumination/map/EffectLines.h"

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/scene/CurvedSurface.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

/// Twelve triangles, all rings flat; the first has the material, the others are black.
Surface Cube(const Material& first)
{
  Surface cube = Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Inward);
  cube.materials = { first, Material() };
  cube.materialOfFacet.assign(cube.facets.size(), 1);
  cube.materialOfFacet[0] = 0;
  return cube;
}

Effects Analysed(const Surface& surface, const EffectSettings& settings = {},
  const Lighting& lighting = PointLamp{})
{
  return AnalyseEffects(Scene(surface), lighting, settings);
}

void ExpectReason(const Effects& effects, const std::string& reason)
{
  const std::vector<std::string> lines = Illumination::EffectLines(effects, {}, 0);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), reason), 1) << reason;
}

} // namespace

TEST(Reasons, NothingIsOnWhereNothingCallsForIt)
{
  const Effects effects = Analysed(Cube({}));
  EXPECT_EQ(effects.present, 0u);
  EXPECT_EQ(effects.registration, Registration::Flat);
  EXPECT_FALSE(effects.colour || effects.colouredFacets);
  const std::vector<std::string> lines = Illumination::EffectLines(effects, {}, 0);
  EXPECT_EQ(lines.size(), 3 + Scatterings + 1 + 4 + 1);
  for (const std::string& reason : lines)
  {
    EXPECT_NE(reason.find(": off, "), std::string::npos) << reason;
  }
  ExpectReason(effects, "compensation: off, all points have the normal of all facets around them");
  ExpectReason(effects, "interreflection: off, no triangle has diffuse reflectance");
  ExpectReason(effects, "clear transmission: off, no triangle has clear transmittance as a pane");
  ExpectReason(
    effects, "colour: off, no triangle and no lamp treats red, green and blue unequally");
}

TEST(Reasons, EachWayOfScatteringIsFoundAndCanBeSwitchedOff)
{
  Material materials[Scatterings];
  materials[0].diffuseReflectance = Colour(0.1f);
  materials[1].specularReflectance = Colour(0.1f);
  materials[2].glossyReflectance = Colour(0.1f);
  materials[3].diffuseTransmittance = Colour(0.1f);
  materials[4].clearTransmittance = Colour(0.1f);
  materials[5].clearTransmittance = Colour(0.1f);
  materials[5].solid = true;
  const char* words[Scatterings][2] = { { "interreflection", "diffuse reflectance" },
    { "specular reflection", "specular reflectance" },
    { "glossy reflection", "glossy reflectance" },
    { "diffuse transmission", "diffuse transmittance" },
    { "clear transmission", "clear transmittance as a pane" },
    { "refraction", "clear transmittance as the surface of a solid body" } };
  for (unsigned s = 0; s < Scatterings; ++s)
  {
    const std::string name = words[s][0];
    const std::string share = std::string("1 of 12 triangles have ") + words[s][1];
    const Effects on = Analysed(Cube(materials[s]));
    EXPECT_EQ(on.present, 1u << s);
    EXPECT_EQ(on.simulated, 1u << s);
    EXPECT_EQ(on.counts.scatteringFacets[s], 1u);
    ExpectReason(on, name + ": on, " + share);
    EffectSettings without;
    without.scatterings = AllScatterings & ~(1u << s);
    const Effects off = Analysed(Cube(materials[s]), without);
    EXPECT_EQ(off.present, 1u << s);
    EXPECT_EQ(off.simulated, 0u);
    ExpectReason(off,
      name + ": off, switched off though " + share +
        "; the photons it would have carried on are counted as cut off");
    std::array<double, Scatterings> lumens{};
    lumens[s] = 12.5;
    const std::string line = Illumination::EffectLines(off, lumens, 0)[3 + s];
    EXPECT_NE(line.find("are counted as cut off, 12.5 lm"), std::string::npos) << line;
  }
}

TEST(Reasons, CompensationIsForTiltedNormals)
{
  const Surface sphere = Shapes::Icosphere(1, Facing::Outward);
  EXPECT_EQ(Analysed(sphere).registration, Registration::VertexNormalised);
  ExpectReason(Analysed(sphere),
    "compensation: on, 42 of 42 points have a normal that differs from a facet's around them");
  EffectSettings flat;
  flat.registration = Registration::Flat;
  EXPECT_EQ(Analysed(sphere, flat).registration, Registration::Flat);
  ExpectReason(Analysed(sphere, flat), "compensation: off, flat registration was chosen");
}

TEST(Reasons, ACurvedSurfaceIsForTiltedNormals)
{
  EffectSettings settings;
  settings.curvedSurface = true;
  ExpectReason(Analysed(Cube({}), settings),
    "curved surface: off, no triangle's normals turn by more than 7 degrees along an edge");
  const Surface sphere = CurvedSurface(Shapes::Icosphere(1, Shapes::Facing::Outward));
  ExpectReason(Analysed(sphere, settings),
    "curved surface: on, 80 of 80 triangles are traced as 5120 parts of curved patches, of which "
    "the normal turns by about 7 degrees at most along an edge");
}

TEST(Reasons, ACurvedSurfaceIsCoarseWhereMemoryIsShort)
{
  EffectSettings settings;
  settings.curvedSurface = true;
  const Surface sphere = Shapes::Icosphere(1, Shapes::Facing::Outward);
  ExpectReason(Analysed(CurvedSurface(sphere, 80), settings),
    "curved surface: off, though triangles are curved: there is no memory for their parts");
  ExpectReason(Analysed(CurvedSurface(sphere, 2000), settings),
    "curved surface: on, 80 of 80 triangles are traced as 1280 parts of curved patches, of which "
    "the normal turns by about 14 degrees at most along an edge; there is no memory for more");
  ExpectReason(Analysed(CurvedSurface(Cube({}), 12), settings),
    "curved surface: off, no triangle's normals turn by more than 7 degrees along an edge");
}

TEST(Reasons, ColourIsForFacetsOrLampsThatHaveOne)
{
  Material red;
  red.specularReflectance = { 0.5f, 0.1f, 0.1f };
  const Effects facets = Analysed(Cube(red));
  EXPECT_TRUE(facets.colour && facets.colouredFacets);
  ExpectReason(facets, "colour: on, 1 of 12 triangles and 0 lamps have a colour");

  Lighting lighting = PointLamp{};
  lighting.luminaires[0].colour = { 1.0f, 0.9f, 0.8f };
  const Effects lamps = Analysed(Cube({}), {}, lighting);
  EXPECT_TRUE(lamps.colour && !lamps.colouredFacets);
  ExpectReason(lamps, "colour: on, 0 of 12 triangles and 1 lamp have a colour");

  Surface shining = Cube({});
  shining.exitance.assign(12, Colour(3.0f));
  EXPECT_FALSE(Analysed(shining).colour);
  shining.exitance[1] = { 1.0f, 2.0f, 3.0f };
  EXPECT_TRUE(Analysed(shining).colour);

  EffectSettings mono;
  mono.colour = false;
  const Effects off = Analysed(Cube(red), mono, lighting);
  EXPECT_FALSE(off.colour || off.colouredFacets);
  ExpectReason(off, "colour: off, switched off though 1 of 12 triangles and 1 lamp have a colour");
}

TEST(Reasons, LampsAndBackSide)
{
  Lighting lighting = CieSky{};
  lighting.luminaires.push_back({ DiskLamp{}, "", Colour(1.0f) });
  lighting.luminaires.push_back({ LineLamp{}, "", Colour(1.0f) });
  lighting.luminaires.push_back({ PhotometricLamp{}, "", Colour(1.0f) });
  EffectSettings settings;
  settings.registerBackSide = true;
  const Effects effects = Analysed(Cube({}), settings, lighting);
  ExpectReason(effects, "back side: on, its registration was asked for");
  const std::vector<std::string> lines = Illumination::EffectLines(effects, {}, 0);
  const auto starts = [&](const std::string& words)
  {
    return std::count_if(lines.begin(), lines.end(),
      [&](const std::string& reason) { return reason.rfind(words, 0) == 0; });
  };
  EXPECT_EQ(starts("area lamps: on, 2 of 4 lamps"), 1);
  EXPECT_EQ(starts("photometric lamps: on, 1 of 4 lamps"), 1);
  EXPECT_EQ(starts("sky: on, 1 of 4 lamps"), 1);
  EXPECT_EQ(starts("choice between lamps: on, 4 of 4 lamps"), 1);
}
