// SPDX-License-Identifier: BSD-3-Clause
// The error of facet size: what must hold in any scene, and the stop rule that counts it. How true
// it is, Validation/FacetErrorTest shows.
#include "Shapes.h"

#include "PhotonTransport/statistics/FacetError.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint64_t ManyPhotons = 1'000'000'000;

const Lamp RoomLamp = PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 };

Surface Room()
{
  return Shapes::WithReflectance(Shapes::RoomWithSphere(1000), 0.5f);
}

/// A cube around a lamp, whose facets are too large at its edges.
Surface Cube()
{
  return Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(-2.0), glm::dvec3(2.0), 10, Facing::Inward), 0.67f);
}
const Lamp CubeLamp = PointLamp{ glm::dvec3(0.0), 1000.0 };

std::vector<double> Total(const IlluminationMap& map)
{
  std::vector<double> total = map.direct;
  std::transform(
    total.begin(), total.end(), map.indirect.begin(), total.begin(), std::plus<double>());
  return total;
}

double Rms(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value * value;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

StopRules Towards(double target, bool countFacetError)
{
  StopRules rules;
  rules.photons = ManyPhotons;
  rules.relativeError = target;
  rules.countFacetError = countFacetError;
  return rules;
}

} // namespace

TEST(FacetError, IsNoneInEvenLight)
{
  const Scene scene(Room());
  const std::size_t size = scene.Vertices().size();
  for (const bool compensated : { false, true })
  {
    for (const double error : FacetError(
           scene, std::vector<double>(size, 300.0), std::vector<double>(size, 0.0), compensated))
    {
      EXPECT_LT(error, 300.0 * 1e-12);
    }
  }
}

/// In a furnace the light is the same everywhere, and all that the map shows is noise.
TEST(FacetError, DoesNotTakeNoiseForError)
{
  const Surface box = Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 8, Facing::Inward);
  const Scene scene(Shapes::WithExitance(Shapes::WithReflectance(box, 0.75f), 100.0f));
  for (const std::uint64_t photons : { 20'000, 200'000, 2'000'000 })
  {
    IlluminationRun run(scene, EmittingFacets(), TraceSettings());
    run.Advance({ photons });
    const IlluminationMap map = run.Front();
    const double share = Rms(run.FacetErrorOf(map)) / Rms(map.standardError);
    std::printf("  %.2f of the standard error\n", share);
    EXPECT_LT(share, 1.0);
  }
}

TEST(FacetError, HasTheSameBitsForAnyThreads)
{
  const Scene scene(Room());
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  run.Advance({ 100'000 });
  const IlluminationMap map = run.Front();
  std::vector<double> first;
  for (const int threads : { 1, 2, 7 })
  {
    std::vector<double> error;
    Threads(threads).Run([&] { error = FacetError(scene, Total(map), map.standardError, true); });
    first = first.empty() ? error : first;
    EXPECT_EQ(error, first) << threads;
  }
  EXPECT_GT(Rms(first), 0.0);
}

TEST(FacetError, GoesWithTheLightHoweverWeakOrStrong)
{
  const Scene scene(Room());
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  run.Advance({ 50'000 });
  const IlluminationMap map = run.Front();
  const std::vector<double> once = run.FacetErrorOf(map);
  for (const double factor : { 0x1p-900, 0x1p900 }) // rounds nothing
  {
    std::vector<double> light = Total(map);
    std::vector<double> noise = map.standardError;
    std::vector<double> expected = once;
    for (std::vector<double>* values : { &light, &noise, &expected })
    {
      std::transform(values->begin(), values->end(), values->begin(),
        [&](double value) { return value * factor; });
    }
    EXPECT_EQ(FacetError(scene, light, noise, true), expected);
  }
  const std::vector<double> dark(scene.Vertices().size(), 0.0);
  EXPECT_EQ(FacetError(scene, dark, dark, true), dark);
}

TEST(FacetError, IsNoneAtAPointWithoutAFacet)
{
  Surface surface = Room();
  surface.points.push_back({ 0.0, 0.0, 0.0 });
  surface.normals.push_back({ 0.0, 0.0, 1.0 });
  const Scene scene(surface);
  IlluminationRun run(scene, RoomLamp, TraceSettings());
  run.Advance({ 50'000 });
  EXPECT_EQ(run.FacetErrorOf(run.Front()).back(), 0.0);
}

TEST(FacetError, EndsARunThatItKeepsFromItsTarget)
{
  const Scene scene(Cube());
  IlluminationRun run(scene, CubeLamp, TraceSettings());
  EXPECT_EQ(run.Advance(Towards(0.001, true)), StopReason::FacetsTooLarge);
  EXPECT_GT(run.Rounds().back().relativeFacetError, 0.001);
  EXPECT_LT(run.Balance().emitted, ManyPhotons / 100);
  EXPECT_EQ(run.Advance(Towards(0.001, true)), StopReason::FacetsTooLarge);
  // The noise alone still falls below another target.
  const double noise = std::sqrt(std::pow(run.Rounds().back().relativeError, 2.0) -
    std::pow(run.Rounds().back().relativeFacetError, 2.0));
  EXPECT_EQ(run.Advance(Towards(0.9 * noise, false)), StopReason::RelativeError);
  EXPECT_EQ(run.Rounds().back().relativeFacetError, 0.0);
}

TEST(FacetError, CountsInTheTarget)
{
  const Scene scene(Cube());
  IlluminationRun alone(scene, CubeLamp, TraceSettings());
  ASSERT_EQ(alone.Advance(Towards(0.001, true)), StopReason::FacetsTooLarge);
  const double target = 1.4 * alone.Rounds().back().relativeFacetError;
  IlluminationRun run(scene, CubeLamp, TraceSettings());
  EXPECT_EQ(run.Advance(Towards(target, true)), StopReason::RelativeError);
  const Accuracy& last = run.Rounds().back();
  EXPECT_LE(last.relativeError, target);
  EXPECT_GT(last.relativeFacetError, 0.5 * target);
  IlluminationRun noiseAlone(scene, CubeLamp, TraceSettings());
  noiseAlone.Advance(Towards(target, false));
  EXPECT_LT(noiseAlone.Balance().emitted, run.Balance().emitted);
  // Counted afterwards, facets bring back what is left to do.
  EXPECT_EQ(noiseAlone.Advance(Towards(target, true)), StopReason::RelativeError);
  EXPECT_GT(noiseAlone.Rounds().back().relativeFacetError, 0.0);
}

TEST(FacetError, IsNotToldOfFinalGathering)
{
  const Scene scene(Room());
  TraceSettings settings;
  settings.method = Method::FinalGathering;
  settings.gatherRays = LeastGatherRays;
  IlluminationRun run(scene, RoomLamp, settings);
  run.Advance({ 10'000 });
  EXPECT_TRUE(run.FacetErrorOf(run.Front()).empty());
}
