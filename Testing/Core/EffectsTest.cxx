// SPDX-License-Identifier: BSD-3-Clause
// The walk that is compiled for a scene's effects gives the bits of the walk with everything in it.
#include "Shapes.h"
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Material Diffuse(const Colour& reflectance)
{
  Material material;
  material.diffuseReflectance = reflectance;
  return material;
}

Material Shiny(const Colour& colour)
{
  Material material = Diffuse(0.3f * colour);
  material.specularReflectance = 0.3f * colour;
  material.glossyReflectance = 0.2f * colour;
  return material;
}

Material Shade(const Colour& colour)
{
  Material material = Diffuse(0.4f * colour);
  material.diffuseTransmittance = 0.4f * colour;
  return material;
}

Material Glass(const Colour& colour, bool solid)
{
  Material material = Diffuse(0.1f * colour);
  material.clearTransmittance = 0.8f * colour;
  material.refractiveIndex = 1.52f;
  material.solid = solid;
  return material;
}

/// Facets with these materials by turns.
Surface With(Surface surface, const std::vector<Material>& materials)
{
  surface.materials = materials;
  surface.materialOfFacet.clear();
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    surface.materialOfFacet.push_back(static_cast<std::uint32_t>(f % materials.size()));
  }
  return surface;
}

struct Named
{
  std::string name;
  Surface surface;
};

/// One for each kind of walk, on surfaces with rings as they come and with flat ones alone.
std::vector<Named> Scenes(const Colour& colour)
{
  const Surface curved = Shapes::RoomWithSphere(500);
  const Surface flat =
    Shapes::Together(Shapes::Box(glm::dvec3(-2.0), glm::dvec3(2.0), 3, Facing::Inward),
      Shapes::Box({ 0.2, 0.3, -0.9 }, { 1.1, 1.2, 0.3 }, 1, Facing::Outward));
  std::vector<Named> scenes;
  for (const Named& shape : { Named{ "curved ", curved }, Named{ "flat ", flat } })
  {
    const auto add = [&](const char* walk, const std::vector<Material>& materials) {
      scenes.push_back({ shape.name + walk, With(shape.surface, materials) });
    };
    add("ends", { Material() });
    add("diffuse", { Diffuse(0.8f * colour), Material() });
    add("reflecting", { Shiny(colour), Diffuse(0.9f * colour) });
    add("transmitting",
      { Diffuse(0.9f * colour), Shade(colour), Glass(colour, false), Glass(colour, true) });
    add("general", { Shiny(colour), Shade(colour), Glass(colour, false), Glass(colour, true) });
    scenes.push_back({ shape.name + "plain", Shapes::WithReflectance(shape.surface, 0.6f) });
  }
  return scenes;
}

Lighting Lamps(bool several, const Colour& colour)
{
  Lighting lighting = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };
  if (several)
  {
    lighting.luminaires.push_back(
      { SphereLamp{ { -1.2, -1.0, -0.5 }, 0.1, 700.0 }, "ball", Colour(1.0f) });
    lighting.luminaires.push_back(
      { RectangleLamp{ { 0.0, 0.0, 1.1 }, { 0.0, 0.1, -1.0 }, 0.5, 0.2, 500.0 }, "panel", colour });
  }
  return lighting;
}

constexpr std::uint64_t Photons = 40 * PhotonBlock;

struct Choice
{
  Registration registration;
  bool backSide, several;
  ScatteringSet scatterings;
};

std::vector<Choice> Choices()
{
  std::vector<Choice> choices;
  for (const Registration registration :
    { Registration::Flat, Registration::FacetRatio, Registration::VertexNormalised })
  {
    for (const bool backSide : { false, true })
    {
      for (const bool several : { false, true })
      {
        choices.push_back({ registration, backSide, several, AllScatterings });
      }
    }
    choices.push_back(
      { registration, true, true, AllScatterings & ~SetOf(Scattering::DiffuseReflection) });
  }
  return choices;
}

void ExpectSpecialWalkIsGeneral(const Named& named, const Colour& light)
{
  const Scene scene(named.surface);
  for (const Choice& choice : Choices())
  {
    SCOPED_TRACE(named.name + ", registration " +
      std::to_string(static_cast<int>(choice.registration)) + (choice.backSide ? ", back" : "") +
      (choice.several ? ", lamps" : "") + ", scatterings " + std::to_string(choice.scatterings));
    TraceSettings settings;
    settings.registration = choice.registration;
    settings.registerBackSide = choice.backSide;
    settings.scatterings = choice.scatterings;
    settings.lampsApart = choice.several;
    settings.weightBound = 1.5f; // cuts something off
    settings.threads = 2;
    const Lighting lighting = Lamps(choice.several, light);
    const TracedMap special(scene, lighting, settings, Photons);
    settings.mostGeneralWalk = true;
    EXPECT_TRUE(special.HasTheBitsOf(TracedMap(scene, lighting, settings, Photons)));
    const bool flat = named.name.rfind("flat", 0) == 0;
    EXPECT_EQ(special.effects.registration, flat ? Registration::Flat : choice.registration);
  }
}

} // namespace

TEST(SpecialWalk, GivesTheBitsOfTheGeneralOne)
{
  for (const Named& named : Scenes(Colour(1.0f)))
  {
    ExpectSpecialWalkIsGeneral(named, Colour(1.0f));
  }
}

TEST(SpecialWalk, OfColouredFacetsGivesTheBitsOfTheGeneralOne)
{
  for (const Named& named : Scenes({ 1.0f, 0.6f, 0.2f }))
  {
    ExpectSpecialWalkIsGeneral(named, Colour(1.0f));
  }
}

TEST(SpecialWalk, OfColouredLampsGivesTheBitsOfTheGeneralOne)
{
  for (const Named& named : Scenes(Colour(1.0f)))
  {
    ExpectSpecialWalkIsGeneral(named, { 1.0f, 0.3f, 0.0f });
  }
}

// Materials that only reflect diffusely and greyly are no more than reflectances.
TEST(SpecialWalk, MaterialsAreReflectancesWhereTheyDoNoMore)
{
  const Surface room = Shapes::RoomWithSphere(500);
  const Scene plain(Shapes::WithReflectance(room, 0.6f));
  const Scene material(With(room, { Diffuse(Colour(0.6f)) }));
  const Lighting lamps = Lamps(true, Colour(1.0f));
  EXPECT_TRUE(
    TracedMap(plain, lamps, {}, Photons).HasTheBitsOf(TracedMap(material, lamps, {}, Photons)));
}

TEST(Mono, GivesColoursTheirLuminousReflectance)
{
  const Colour colour(0.9f, 0.5f, 0.1f);
  const Colour grey(Luminous(colour));
  const Surface room = Shapes::RoomWithSphere(500);
  TraceSettings settings;
  settings.colour = false;
  const Lighting lamps = Lamps(true, { 1.0f, 0.0f, 0.0f });
  const Scene coloured(With(room, { Diffuse(colour), Material() }));
  const Scene luminous(With(room, { Diffuse(grey), Material() }));
  const TracedMap traced(coloured, lamps, settings, Photons);
  EXPECT_FALSE(traced.effects.colour);
  EXPECT_TRUE(traced.frontByColour.empty());
  EXPECT_TRUE(traced.HasTheBitsOf(TracedMap(luminous, lamps, settings, Photons)));
}

TEST(SwitchedOff, CountsWhatItWouldHaveCarried)
{
  const Surface room = Shapes::RoomWithSphere(500);
  Material material = Diffuse(Colour(0.35f));
  material.specularReflectance = Colour(0.2f);
  material.glossyReflectance = Colour(0.1f);
  material.diffuseTransmittance = Colour(0.05f);
  material.roughness = 0.01f;
  const Scene scene(With(room, { material }));
  const double shares[] = { 0.35, 0.2, 0.1, 0.05 };
  const TracedMap all(scene, Lamps(true, Colour(1.0f)), {}, 10 * Photons);
  EXPECT_EQ(all.balance.cutOff, 0u);
  for (unsigned s = 0; s < 4; ++s)
  {
    TraceSettings settings;
    settings.scatterings = AllScatterings & ~(1u << s);
    const TracedMap without(scene, Lamps(true, Colour(1.0f)), settings, 10 * Photons);
    const PhotonBalance& balance = without.balance;
    // At each of the hits one photon in 1 / share takes that way: four binomial deviations.
    const auto hits = static_cast<double>(balance.segments - balance.escaped);
    const auto counted = static_cast<double>(balance.switchedOff[s]);
    EXPECT_NEAR(counted, hits * shares[s], 4.0 * std::sqrt(hits * shares[s] * (1.0 - shares[s])));
    EXPECT_EQ(balance.cutOff, balance.switchedOff[s]);
    EXPECT_EQ(without.front.direct, all.front.direct);
    for (std::size_t v = 0; v < all.front.indirect.size(); ++v)
    {
      ASSERT_LE(without.front.indirect[v], all.front.indirect[v]);
    }
  }
}

TEST(SwitchedOff, ChangesNothingThatTheSceneDoesNotHave)
{
  const Scene scene(With(Shapes::RoomWithSphere(500), { Shiny(Colour(1.0f)) }));
  TraceSettings settings;
  settings.scatterings = AllScatterings & ~Transmissions;
  const Lighting lamp = Lamps(false, Colour(1.0f));
  EXPECT_TRUE(
    TracedMap(scene, lamp, {}, Photons).HasTheBitsOf(TracedMap(scene, lamp, settings, Photons)));
}
