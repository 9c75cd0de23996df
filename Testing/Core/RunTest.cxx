// SPDX-License-Identifier: BSD-3-Clause
// Going on, stopping, predicting.
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace PhotonTransport;

namespace
{

const Lamp RoomLamp = PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 };

Scene Room(float reflectance)
{
  return Scene(Shapes::WithReflectance(Shapes::RoomWithSphere(2000), reflectance));
}

void ExpectSame(const IlluminationMap& a, const IlluminationMap& b)
{
  EXPECT_EQ(a.direct, b.direct);
  EXPECT_EQ(a.indirect, b.indirect);
  EXPECT_EQ(a.standardError, b.standardError);
  EXPECT_EQ(a.photonHits, b.photonHits);
}

/// sum A E, lm
double RegisteredFlux(const Scene& scene, const IlluminationMap& map)
{
  double flux = 0.0;
  for (std::size_t v = 0; v < scene.VertexAreas().size(); ++v)
  {
    flux += scene.VertexAreas()[v] * (map.direct[v] + map.indirect[v]);
  }
  return flux;
}

} // namespace

TEST(Run, GoingOnGivesTheBitsOfARunInOneGo)
{
  const Scene scene = Room(0.6f);
  IlluminationRun once(scene, RoomLamp, TraceSettings());
  once.Advance({ 600'000 });
  IlluminationRun parts(scene, RoomLamp, TraceSettings());
  EXPECT_EQ(parts.Advance({ 100'000 }), StopReason::PhotonLimit);
  EXPECT_EQ(parts.Advance({ 100'000 }), StopReason::PhotonLimit); // nothing to do
  EXPECT_EQ(
    parts.Advance({ std::numeric_limits<std::uint32_t>::max(), 0.0, 0.01 }), StopReason::TimeLimit);
  EXPECT_LT(parts.Balance().emitted, 600'000u);
  parts.Advance({ 600'000 });
  ExpectSame(once.Front(), parts.Front());
  EXPECT_TRUE(parts.CanGoOn());
}

// The map of the photons alone has all their light, caustics once, in a closed room whose walls
// mirror, too. What follows has the bits of a run without it.
TEST(Run, APreliminaryMapHasAllLightAndLeavesNoTrace)
{
  Surface ball = Shapes::Icosphere(2, Shapes::Facing::Inward);
  ball.materials = { Material() };
  ball.materials[0].diffuseReflectance = Colour(0.4f);
  ball.materials[0].specularReflectance = Colour(0.4f);
  ball.materialOfFacet.assign(ball.facets.size(), 0);
  const Scene scene(ball);
  const PointLamp lamp{ { 0.3, -0.2, 0.1 }, 1000.0 };
  StopRules rules{ 50'000 };
  TraceSettings settings;
  settings.registration = Registration::Flat; // by which the sum over vertices is that over facets
  IlluminationRun photons(scene, lamp, settings);
  photons.Advance(rules);
  EXPECT_FALSE(photons.IsPreliminary());
  settings.method = Method::FinalGathering;
  settings.gatherRays = 16;
  IlluminationRun once(scene, lamp, settings);
  once.Advance(rules);
  IlluminationRun run(scene, lamp, settings);
  rules.preliminary = true;
  for (int time = 0; time < 2; ++time) // the second has nothing to trace
  {
    EXPECT_EQ(run.Advance(rules), StopReason::PhotonLimit);
    EXPECT_TRUE(run.IsPreliminary());
    EXPECT_TRUE(run.Rounds().empty());
    const double flux = RegisteredFlux(scene, photons.Front());
    EXPECT_NEAR(RegisteredFlux(scene, run.Front()), flux, 1e-5 * flux);
  }
  const IlluminationMap first = run.Front();
  EXPECT_GT(
    *std::max_element(first.caustic.begin(), first.caustic.end()), 0.0); // or nothing is shown
  rules.preliminary = false;
  EXPECT_EQ(run.Advance(rules), StopReason::PhotonLimit);
  EXPECT_FALSE(run.IsPreliminary());
  EXPECT_EQ(run.Rounds().size(), 1u);
  ExpectSame(run.Front(), once.Front());
}

TEST(Run, StopsAtTheFirstRuleReached)
{
  const Scene scene = Room(0.6f);
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  EXPECT_EQ(run.Advance({ 10'000 }), StopReason::PhotonLimit);
  EXPECT_EQ(run.Balance().emitted, 10'240u); // whole blocks of all replicates
  EXPECT_EQ(run.Advance({ 100'000'000, 0.05 }), StopReason::RelativeError);
  EXPECT_LE(run.Rounds().back().relativeError, 0.05);
  // Rounds aim a little beyond the prediction, so the target is hardly overshot.
  EXPECT_GE(run.Rounds().back().relativeError, 0.05 / std::sqrt(1.5));
  EXPECT_EQ(run.Advance({ 1'000'000'000, 1e-6, run.Seconds() + 0.05 }), StopReason::TimeLimit);
  EXPECT_LT(run.Balance().emitted, 100'000'000u);
}

// A stopped run is a valid map of the photons it traced.
TEST(Run, AbortLeavesAValidMap)
{
  const Scene scene = Room(0.0f);
  TraceSettings settings;
  settings.registration = Registration::Flat;
  IlluminationRun run(scene, RoomLamp, settings);
  double reached = 0.0;
  const StopReason reason = run.Advance({ 100'000'000 },
    [&](const RunProgress& progress)
    {
      EXPECT_GE(progress.fraction, reached);
      EXPECT_GE(progress.secondsLeft, 0.0);
      reached = progress.fraction;
      return progress.fraction < 0.002;
    });
  EXPECT_EQ(reason, StopReason::Abort);
  EXPECT_FALSE(run.CanGoOn());
  const PhotonBalance balance = run.Balance();
  EXPECT_GE(balance.emitted, 100'000u);
  EXPECT_LT(balance.emitted, 10'000'000u);
  EXPECT_EQ(balance.emitted, balance.absorbed + balance.escaped + balance.cutOff);
  // Every photon lands on a front of the closed room or on the sphere in it, so sum A E = flux.
  EXPECT_NEAR(RegisteredFlux(scene, run.Front()), 1000.0, 1000.0 * 1e-6); // float weights
}

// A scene that light has not reached yet must not look finished.
TEST(Run, DarknessIsNotAccuracy)
{
  const Scene scene(Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2));
  IlluminationRun run(scene, PointLamp{ { 0.5, 0.5, -1.0 }, 10.0 }, TraceSettings()); // from behind
  EXPECT_EQ(run.Advance({ 20'000, 0.1 }), StopReason::PhotonLimit);
  EXPECT_EQ(run.Rounds().back().relativeError, 1.0);
  EXPECT_EQ(RegisteredFlux(scene, run.Front()), 0.0);
}

// A region of everything is the whole; another one is measured on the map as it is, and forgets
// what earlier rows were measured on.
TEST(Run, ARegionHasErrorsOfItsOwn)
{
  const Scene scene = Room(0.6f);
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  run.Advance({ 100'000 });
  ASSERT_GE(run.Rounds().size(), 2u);
  const Accuracy whole = run.Rounds().back();
  EXPECT_FALSE(whole.region);
  std::vector<double> shares(scene.VertexAreas().size(), 1.0);
  run.SetRegion(shares);
  EXPECT_EQ(run.Rounds().back().region->relativeError, whole.relativeError);
  EXPECT_EQ(run.Rounds().back().region->medianRelativeError, whole.medianRelativeError);
  EXPECT_FALSE(run.Rounds().front().region);

  std::fill(shares.begin() + 1, shares.end(), 0.0); // one vertex
  run.SetRegion(shares);
  const IlluminationMap map = run.Front();
  const double relative = map.standardError[0] / (map.direct[0] + map.indirect[0]);
  const MapErrors ofVertex = *run.Rounds().back().region;
  EXPECT_DOUBLE_EQ(ofVertex.relativeError, relative);
  EXPECT_EQ(ofVertex.medianRelativeError, relative);
  EXPECT_EQ(run.Rounds().back().relativeError, whole.relativeError);
  EXPECT_EQ(run.Rounds().back().photons, whole.photons);

  // A target that the whole has met already is not yet met there.
  EXPECT_GT(relative, whole.relativeError);
  EXPECT_EQ(run.Advance({ 100'000'000, whole.relativeError }), StopReason::RelativeError);
  EXPECT_LE(run.Rounds().back().region->relativeError, whole.relativeError);
  EXPECT_GT(run.Rounds().back().photons, whole.photons);
}

TEST(Run, RefusesRulesThatMakeNoSense)
{
  const Scene scene = Room(0.5f);
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run.Advance({ 0 }), InvalidInput);
  EXPECT_THROW(run.Advance({ 20'000'000'000u }), InvalidInput);
  EXPECT_THROW(run.Advance({ 1000, -0.1 }), InvalidInput);
  EXPECT_THROW(run.Advance({ 1000, nan }), InvalidInput);
  EXPECT_THROW(run.Advance({ 1000, 0.0, nan }), InvalidInput);
}

// The photons predicted after about a tenth of the run, against those it took.
TEST(Run, PredictsWhatTheTargetCosts)
{
  const Scene scene = Room(0.6f);
  TraceSettings settings;
  for (const Sampling sampling : { Sampling::Random, Sampling::Sobol })
  {
    settings.sampling = sampling;
    IlluminationRun run(scene, RoomLamp, settings);
    ASSERT_EQ(run.Advance({ 1'000'000'000, 0.02 }), StopReason::RelativeError);
    const auto took = static_cast<double>(run.Rounds().back().photons);
    for (const Accuracy& row : run.Rounds())
    {
      if (static_cast<double>(row.photons) >= 0.1 * took)
      {
        EXPECT_NEAR(row.predictedPhotons / took, 1.0, 0.3);
        break;
      }
    }
  }
}
