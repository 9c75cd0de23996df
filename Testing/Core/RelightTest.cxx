// SPDX-License-Identifier: BSD-3-Clause
// Maps of other fluxes, dimming and colours of lamps, from photons that are traced already.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Scene Room(float reflectance = 0.5f)
{
  return Scene(Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 6, Facing::Inward), reflectance));
}

TraceSettings Apart(std::uint32_t seed = 1)
{
  TraceSettings settings;
  settings.lampsApart = true;
  settings.registerBackSide = true;
  settings.seed = seed;
  return settings;
}

/// A point, a spot and a panel at random places, with random fluxes.
Lighting RandomLamps(std::mt19937& random)
{
  std::uniform_real_distribution<double> place(-0.8, 0.8);
  std::uniform_real_distribution<double> power(0.0, 3.0);
  const auto at = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  const auto flux = [&] { return std::pow(10.0, power(random)); };
  Lighting lighting;
  lighting.luminaires.push_back({ PointLamp{ at(), flux() }, "point", Colour(1.0f) });
  lighting.luminaires.push_back(
    { SpotLamp{ at(), { 0.1, 0.2, -1.0 }, 0.5, 0.0, flux() }, "spot", Colour(1.0f) });
  lighting.luminaires.push_back(
    { RectangleLamp{ at(), { 0.0, 0.3, -1.0 }, 0.2, 0.1, flux() }, "panel", Colour(1.0f) });
  return lighting;
}

double& FluxOf(Luminaire& luminaire)
{
  return luminaire.lamp.index() == Lamp(PointLamp()).index()
    ? std::get<PointLamp>(luminaire.lamp).flux
    : luminaire.lamp.index() == Lamp(SpotLamp()).index()
    ? std::get<SpotLamp>(luminaire.lamp).flux
    : std::get<RectangleLamp>(luminaire.lamp).flux;
}

/// Another flux, another dimming, and a lamp that is off.
Lighting Relit(Lighting lighting)
{
  FluxOf(lighting.luminaires[0]) *= 3.7;
  lighting.luminaires[1].dimming = 0.3;
  lighting.luminaires[2].dimming = 0.0;
  return lighting;
}

void ExpectSame(const IlluminationMap& a, const IlluminationMap& b)
{
  EXPECT_EQ(a.direct, b.direct);
  EXPECT_EQ(a.indirect, b.indirect);
  EXPECT_EQ(a.standardError, b.standardError);
  EXPECT_EQ(a.photonHits, b.photonHits);
}

/// The mean of numbers, and its standard error.
struct Mean
{
  explicit Mean(const std::vector<double>& numbers)
  {
    const auto n = static_cast<double>(numbers.size());
    for (const double number : numbers)
    {
      this->value += number / n;
    }
    for (const double number : numbers)
    {
      this->error += std::pow(number - this->value, 2.0) / (n * (n - 1.0));
    }
    this->error = std::sqrt(this->error);
  }
  double value = 0.0;
  double error = 0.0;
};

} // namespace

TEST(Relight, IsTheSumOfTheLampsTimesTheirFactors)
{
  const Scene scene = Room();
  std::mt19937 random(1);
  const Lighting lighting = RandomLamps(random);
  const Lighting wanted = Relit(lighting);
  IlluminationRun run(scene, lighting, Apart());
  run.Advance({ 30'000 });
  std::vector<IlluminationMap> lamps;
  for (std::size_t l = 0; l < 3; ++l)
  {
    lamps.push_back(run.MapOfLamp(l));
  }
  const std::uint64_t photons = run.Balance().emitted;
  ASSERT_TRUE(run.Relight(wanted));
  EXPECT_TRUE(run.IsRelit());
  EXPECT_EQ(run.Balance().emitted, photons);
  const double factors[] = { 3.7, 0.3, 0.0 };
  const IlluminationMap front = run.Front();
  const GroupMeans groups = run.FrontByGroups();
  for (std::size_t v = 0; v < front.direct.size(); ++v)
  {
    double direct = 0.0;
    double indirect = 0.0;
    for (std::size_t l = 0; l < 3; ++l)
    {
      direct += factors[l] * lamps[l].direct[v];
      indirect += factors[l] * lamps[l].indirect[v];
    }
    EXPECT_NEAR(front.direct[v], direct, 16.0 * 0x1p-53 * direct);
    EXPECT_NEAR(front.indirect[v], indirect, 16.0 * 0x1p-53 * indirect);
    double means = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      means += (groups.direct[v][g] + groups.indirect[v][g]) / Groups;
    }
    EXPECT_NEAR(means, direct + indirect, 64.0 * 0x1p-53 * (direct + indirect));
    EXPECT_EQ(front.photonHits[v], lamps[0].photonHits[v] + lamps[1].photonHits[v]);
  }
  double flux = 0.0;
  for (const Luminaire& luminaire : wanted.luminaires)
  {
    Luminaire own = luminaire;
    flux += own.dimming * FluxOf(own);
  }
  EXPECT_NEAR(run.Flux(), flux, 1e-12 * flux);
  EXPECT_NEAR(run.BalanceOfFlux().emitted, flux, 0.02 * flux); // photons are divided by a sequence
  EXPECT_EQ(run.FluxArrivedByLamp()[2].front, 0.0);
}

TEST(Relight, BackToTheFormerLightHasTheFormerBits)
{
  const Scene scene = Room();
  std::mt19937 random(2);
  const Lighting lighting = RandomLamps(random);
  IlluminationRun run(scene, lighting, Apart());
  run.Advance({ 30'000 });
  const IlluminationMap front = run.Front();
  const IlluminationMap back = run.Back();
  const IlluminationMap own = run.MapOfLamp(1);
  const double error = run.Rounds().back().relativeError;
  ASSERT_TRUE(run.Relight(Relit(lighting)));
  EXPECT_NE(run.Front().direct, front.direct);
  EXPECT_NE(run.Rounds().back().relativeError, error);
  ASSERT_TRUE(run.Relight(lighting));
  EXPECT_FALSE(run.IsRelit());
  ExpectSame(run.Front(), front);
  ExpectSame(run.Back(), back);
  ExpectSame(run.MapOfLamp(1), own);
  EXPECT_EQ(run.Rounds().back().relativeError, error);
}

// Whether a run starts dimmed, is dimmed half-way or in the end, it traces the same photons.
TEST(Relight, DoesNotChangeWhatIsTraced)
{
  const Scene scene = Room();
  std::mt19937 random(3);
  const Lighting lighting = RandomLamps(random);
  Lighting dimmed = lighting;
  dimmed.luminaires[0].dimming = 0.0;
  dimmed.luminaires[2].dimming = 0.2;
  IlluminationRun fromTheStart(scene, dimmed, Apart());
  fromTheStart.Advance({ 40'000 });
  IlluminationRun halfWay(scene, lighting, Apart());
  halfWay.Advance({ 20'000 });
  ASSERT_TRUE(halfWay.Relight(dimmed));
  halfWay.Advance({ 40'000 });
  ExpectSame(halfWay.Front(), fromTheStart.Front());
  ASSERT_TRUE(fromTheStart.Relight(lighting));
  IlluminationRun undimmed(scene, lighting, Apart());
  undimmed.Advance({ 40'000 });
  ExpectSame(fromTheStart.Front(), undimmed.Front());
}

// Against runs of other seeds with the new fluxes: the squared difference is what both maps tell.
TEST(Relight, AgreesWithTracingAnew)
{
  const Scene scene = Room();
  std::vector<double> ofMap;
  std::vector<double> ofLamp;
  for (std::uint32_t seed = 1; seed <= 40; ++seed)
  {
    std::mt19937 random(seed);
    const Lighting lighting = RandomLamps(random);
    const Lighting wanted = Relit(lighting);
    IlluminationRun run(scene, lighting, Apart(seed));
    run.Advance({ 60'000 });
    ASSERT_TRUE(run.Relight(wanted));
    IlluminationRun anew(scene, wanted, Apart(1000 + seed));
    anew.Advance({ 60'000 });
    const auto ratio = [](const IlluminationMap& a, const IlluminationMap& b)
    {
      double squares = 0.0;
      double told = 0.0;
      for (std::size_t v = 0; v < a.direct.size(); ++v)
      {
        squares += std::pow(a.direct[v] + a.indirect[v] - b.direct[v] - b.indirect[v], 2.0);
        told += std::pow(a.standardError[v], 2.0) + std::pow(b.standardError[v], 2.0);
      }
      return squares / told;
    };
    ofMap.push_back(ratio(run.Front(), anew.Front()));
    ofLamp.push_back(ratio(run.MapOfLamp(1), anew.MapOfLamp(1)));
  }
  for (const Mean& mean : { Mean(ofMap), Mean(ofLamp) })
  {
    std::printf("  squared difference over what is told: %.3f +- %.3f\n", mean.value, mean.error);
    // Where few hits came, errors are told up to 1.4 times too large.
    EXPECT_NEAR(mean.value, 1.0, 4.0 * mean.error + 0.1);
  }
}

TEST(Relight, IsRefusedWhereTracingIsCalledFor)
{
  const Scene scene = Room();
  std::mt19937 random(4);
  const Lighting lighting = RandomLamps(random);
  Lighting dark = lighting;
  FluxOf(dark.luminaires[1]) = 0.0;
  IlluminationRun run(scene, dark, Apart());
  EXPECT_TRUE(run.Relight(dark));
  EXPECT_FALSE(run.Relight(lighting)) << "no photon has left lamp 1";
  Lighting moved = dark;
  std::get<PointLamp>(moved.luminaires[0].lamp).position.x += 0.1;
  EXPECT_FALSE(run.Relight(moved));
  Lighting other = dark;
  other.luminaires[0].lamp = SphereLamp{ { 0, 0, 0 }, 0.1, 100.0 };
  EXPECT_FALSE(run.Relight(other));
  Lighting fewer = dark;
  fewer.luminaires.pop_back();
  EXPECT_FALSE(run.Relight(fewer));
  Lighting turned = dark;
  std::get<RectangleLamp>(turned.luminaires[2].lamp).across = { 0.0, 1.0, 0.3 };
  EXPECT_FALSE(run.Relight(turned));
  Lighting wrong = dark;
  wrong.luminaires[0].dimming = std::nan("");
  EXPECT_FALSE(run.Relight(wrong));
  EXPECT_FALSE(run.IsRelit());
  Lighting renamed = dark;
  renamed.luminaires[0].name = "another";
  EXPECT_TRUE(run.Relight(renamed));
  TraceSettings together = Apart();
  together.lampsApart = false;
  IlluminationRun whole(scene, lighting, together);
  EXPECT_FALSE(whole.Relight(Relit(lighting)));
  TraceSettings gathering = Apart();
  gathering.method = Method::FinalGathering;
  IlluminationRun gathered(scene, lighting, gathering);
  EXPECT_FALSE(gathered.Relight(Relit(lighting)));
}

// All light is multiplied, by a power of two without rounding.
TEST(Relight, OneFactorOfAllLampsNeedsNoLampsApart)
{
  const Scene scene = Room();
  std::mt19937 random(6);
  Lighting lighting = RandomLamps(random);
  lighting.luminaires[0].colour = { 1.0f, 0.5f, 0.2f };
  Lighting brighter = lighting;
  for (Luminaire& luminaire : brighter.luminaires)
  {
    FluxOf(luminaire) *= 4.0;
    luminaire.dimming = 0.5;
  }
  for (const Method method : { Method::PhotonTracing, Method::FinalGathering })
  {
    SCOPED_TRACE(static_cast<int>(method));
    TraceSettings settings = Apart();
    settings.lampsApart = false;
    settings.method = method;
    settings.gatherRays = 32;
    IlluminationRun run(scene, lighting, settings), anew(scene, brighter, settings);
    run.Advance({ 20'000 });
    const IlluminationMap before = run.Front();
    ASSERT_TRUE(run.Relight(brighter));
    EXPECT_TRUE(run.IsRelit());
    EXPECT_FALSE(run.IsOfOtherShares());
    for (const std::uint64_t photons : { 20'000, 60'000 }) // the latter are traced after relighting
    {
      run.Advance({ photons });
      anew.Advance({ photons });
      ExpectSame(run.Front(), anew.Front());
      ExpectSame(run.Back(), anew.Back());
      EXPECT_EQ(run.FrontByColour(), anew.FrontByColour());
      EXPECT_EQ(run.ColourErrors(), anew.ColourErrors());
      EXPECT_EQ(run.FrontByGroups().direct, anew.FrontByGroups().direct);
      EXPECT_EQ(run.Rounds().back().relativeError, anew.Rounds().back().relativeError);
      EXPECT_EQ(run.Flux(), anew.Flux());
      EXPECT_EQ(run.BalanceOfFlux().absorbed, anew.BalanceOfFlux().absorbed);
    }
    Lighting other = brighter;
    FluxOf(other.luminaires[1]) *= 1.001;
    EXPECT_FALSE(run.Relight(other)) << "one lamp alone";
    for (Luminaire& luminaire : other.luminaires)
    {
      luminaire.dimming = 0.0;
    }
    EXPECT_FALSE(run.Relight(other)) << "no light at all";
    EXPECT_TRUE(run.Relight(lighting));
    EXPECT_FALSE(run.IsRelit());
    for (std::size_t v = 0; v < before.direct.size(); ++v) // of more photons by now
    {
      EXPECT_NEAR(run.Front().Total(v), before.Total(v), 8.0 * before.standardError[v]);
    }
  }
}

// The exitance of a mesh is in single precision, for each facet.
TEST(Relight, MayScaleTheExitanceOfMeshes)
{
  const Scene scene = Room();
  EmittingMesh mesh{ { { 0, 0, 0 }, { 0.5, 0, 0 }, { 0, 0.5, 0 }, { 0.5, 0.5, 0 } },
    { { 0, 1, 2 }, { 1, 3, 2 } }, { 100.0f, 37.0f } };
  IlluminationRun run(scene, mesh, Apart());
  run.Advance({ 10'000 });
  const IlluminationMap before = run.Front();
  for (float& exitance : mesh.exitance)
  {
    exitance *= 0.3f;
  }
  ASSERT_TRUE(run.Relight(mesh));
  const IlluminationMap after = run.Front();
  for (std::size_t v = 0; v < before.direct.size(); ++v)
  {
    EXPECT_NEAR(after.indirect[v], 0.3 * before.indirect[v], 0x1p-22 * before.indirect[v]);
  }
  mesh.exitance[0] *= 1.01f;
  EXPECT_FALSE(run.Relight(mesh));
}

TEST(Relight, ColoursOfLampsAreThoseOfTheirLightInGreyRooms)
{
  const Scene scene = Room();
  std::mt19937 random(5);
  const Lighting lighting = RandomLamps(random);
  IlluminationRun run(scene, lighting, Apart());
  run.Advance({ 30'000 });
  EXPECT_TRUE(run.FrontByColour().empty());
  const IlluminationMap white = run.Front();
  Lighting coloured = lighting;
  coloured.luminaires[0].colour = { 1.0f, 0.0f, 0.0f };
  coloured.luminaires[1].colour = { 0.2f, 0.5f, 1.0f };
  ASSERT_TRUE(run.Relight(coloured));
  EXPECT_TRUE(run.IsRelit());
  ExpectSame(run.Front(), white);
  IlluminationRun anew(scene, coloured, Apart());
  anew.Advance({ 30'000 });
  EXPECT_EQ(run.FrontByColour(), anew.FrontByColour());
  const auto byColour = run.FrontByColour();
  const auto errors = run.ColourErrors();
  for (std::size_t v = 0; v < white.direct.size(); ++v)
  {
    double whole = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      whole += double{ LuminousWeights[c] } * byColour[v][static_cast<std::size_t>(c)];
    }
    EXPECT_NEAR(whole, white.direct[v] + white.indirect[v], 1e-6 * whole);
    const IlluminationMap red = run.MapOfLamp(0);
    EXPECT_GE(
      byColour[v][0] * 1.0000001, (red.direct[v] + red.indirect[v]) / double{ LuminousWeights.x });
    EXPECT_GT(errors[v][0], 0.0);
  }
  Lighting wrong = coloured;
  wrong.luminaires[0].colour = Colour(0.0f);
  EXPECT_FALSE(run.Relight(wrong));
}

// Photons take the colours of walls, so another colour of a lamp needs other photons.
TEST(Relight, ColoursOfLampsCallForTracingInColouredRooms)
{
  Surface room = Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 3, Facing::Inward);
  Material material;
  material.diffuseReflectance = { 0.8f, 0.5f, 0.2f };
  room.materials = { material };
  room.materialOfFacet.assign(room.facets.size(), 0);
  const Scene scene(room);
  std::mt19937 random(6);
  const Lighting lighting = RandomLamps(random);
  IlluminationRun run(scene, lighting, Apart());
  run.Advance({ 30'000 });
  const auto before = run.FrontByColour();
  Lighting dimmed = lighting;
  for (Luminaire& luminaire : dimmed.luminaires)
  {
    luminaire.dimming = 0.5;
  }
  ASSERT_TRUE(run.Relight(dimmed));
  const auto after = run.FrontByColour();
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(after[v][c], 0.5 * before[v][c], 1e-12 * before[v][c]);
    }
  }
  dimmed.luminaires[0].colour = { 1.0f, 0.5f, 0.2f };
  EXPECT_FALSE(run.Relight(dimmed));
}
