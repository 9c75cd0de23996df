// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/PhotonTracer.h"

#include "Shapes.h"
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Surface Room(float reflectance)
{
  return Shapes::WithReflectance(Shapes::RoomWithSphere(2000), reflectance);
}

const Lamp RoomLamp = PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 };

bool SameSums(const std::vector<VertexSums>& a, const std::vector<VertexSums>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const VertexSums& x, const VertexSums& y)
    { return x.direct == y.direct && x.indirect == y.indirect && x.hits == y.hits; });
}

bool Same(const IlluminationSums& a, const IlluminationSums& b)
{
  return SameSums(a.front, b.front) && SameSums(a.back, b.back) &&
    a.cutByWeightBound == b.cutByWeightBound && a.Balance().emitted == b.Balance().emitted &&
    a.Balance().absorbed == b.Balance().absorbed && a.Balance().segments == b.Balance().segments;
}

void ExpectBalanced(const PhotonBalance& balance)
{
  EXPECT_EQ(balance.emitted, balance.absorbed + balance.escaped + balance.cutOff);
}

} // namespace

TEST(ReplicateStatistics, GivesTheTextbookStandardError)
{
  ReplicateStatistics statistics;
  for (const double value : { 1.0, 2.0, 4.0, 5.0 })
  {
    statistics.Add(value, 100.0);
  }
  statistics.Add(1e9, 0.0); // emitted nothing: no evidence
  EXPECT_DOUBLE_EQ(statistics.Mean(), 3.0);
  EXPECT_DOUBLE_EQ(statistics.StandardError(), std::sqrt((4.0 + 1.0 + 1.0 + 4.0) / 3.0 / 4.0));
}

TEST(ReplicateStatistics, WeighsReplicatesByTheirPhotons)
{
  ReplicateStatistics statistics;
  statistics.Add(1.0, 300.0);
  statistics.Add(5.0, 100.0);
  EXPECT_DOUBLE_EQ(statistics.Mean(), 2.0);
  EXPECT_DOUBLE_EQ(statistics.StandardError(), std::sqrt((300.0 * 1.0 + 100.0 * 9.0) / 400.0));
}

std::string NameOf(const testing::TestParamInfo<Registration>& instance)
{
  switch (instance.param)
  {
    case Registration::Flat:
      return "Flat";
    case Registration::FacetRatio:
      return "FacetRatio";
    default:
      return "VertexNormalised";
  }
}

class EveryRegistration : public testing::TestWithParam<Registration>
{
};
INSTANTIATE_TEST_SUITE_P(Transport, EveryRegistration,
  testing::Values(Registration::Flat, Registration::FacetRatio, Registration::VertexNormalised),
  NameOf);

TEST_P(EveryRegistration, ThreadsDoNotChangeABit)
{
  const Scene scene(Room(0.6f));
  TraceSettings settings;
  settings.registration = GetParam();
  settings.registerBackSide = true;
  settings.threads = 1;
  PhotonTracer alone(scene, RoomLamp, settings);
  IlluminationSums expected = alone.EmptySums();
  alone.Trace(0, 0, 200, expected);
  ExpectBalanced(expected.Balance());
  EXPECT_GT(expected.Balance().segments, 100000u);
  for (const int threads : { 2, 3, 8 })
  {
    settings.threads = threads;
    PhotonTracer tracer(scene, RoomLamp, settings);
    IlluminationSums sums = tracer.EmptySums();
    tracer.Trace(0, 0, 200, sums);
    EXPECT_TRUE(Same(sums, expected)) << threads << " threads";
  }
}

TEST_P(EveryRegistration, DividingARangeDoesNotChangeABit)
{
  const Scene scene(Room(0.6f));
  TraceSettings settings;
  settings.registration = GetParam();
  PhotonTracer tracer(scene, RoomLamp, settings);
  IlluminationSums whole = tracer.EmptySums();
  IlluminationSums parts = tracer.EmptySums();
  tracer.Trace(3, 0, 120, whole);
  tracer.Trace(3, 70, 50, parts);
  tracer.Trace(3, 0, 70, parts);
  EXPECT_TRUE(Same(whole, parts));
}

TEST(Transport, ReplicatesAndSeedsAreIndependent)
{
  const Scene scene(Room(0.6f));
  PhotonTracer tracer(scene, RoomLamp, TraceSettings());
  TraceSettings other;
  other.seed = 2;
  PhotonTracer otherTracer(scene, RoomLamp, other);
  IlluminationSums a = tracer.EmptySums(), b = a, c = a;
  tracer.Trace(0, 0, 20, a);
  tracer.Trace(1, 0, 20, b);
  otherTracer.Trace(0, 0, 20, c);
  EXPECT_FALSE(SameSums(a.front, b.front));
  EXPECT_FALSE(SameSums(a.front, c.front));
}

// Without reflecting facets the walk has no bounce; the result must be that of the general walk.
TEST(Transport, WalkWithoutBouncesGivesTheSameBits)
{
  const Scene black(Room(0.0f));
  Surface almostBlack = Room(0.0f);
  almostBlack.materials.resize(2);
  almostBlack.materials[1].diffuseReflectance = Colour(1e-30f); // reflects nothing
  almostBlack.materialOfFacet[0] = 1;                           // but calls for the general walk
  const Scene general(almostBlack);
  PhotonTracer special(black, RoomLamp, TraceSettings());
  PhotonTracer full(general, RoomLamp, TraceSettings());
  EXPECT_EQ(special.EffectsInUse().present, 0u);
  EXPECT_NE(full.EffectsInUse().present, 0u);
  IlluminationSums a = special.EmptySums(), b = full.EmptySums();
  special.Trace(0, 0, 80, a);
  full.Trace(0, 0, 80, b);
  EXPECT_TRUE(Same(a, b));
}

// Registering the back must not change the front.
TEST(Transport, BackSideDoesNotChangeTheFront)
{
  const Scene scene(Room(0.5f));
  TraceSettings settings;
  PhotonTracer frontOnly(scene, RoomLamp, settings);
  settings.registerBackSide = true;
  PhotonTracer both(scene, RoomLamp, settings);
  IlluminationSums a = frontOnly.EmptySums(), b = both.EmptySums();
  frontOnly.Trace(0, 0, 80, a);
  both.Trace(0, 0, 80, b);
  EXPECT_TRUE(SameSums(a.front, b.front));
}

TEST(Transport, InterreflectionSwitchedOffCountsWhatItCutOff)
{
  const Scene scene(Room(0.5f));
  TraceSettings settings;
  settings.scatterings = 0;
  const TracedMap map(scene, RoomLamp, settings, 100000);
  ExpectBalanced(map.balance);
  EXPECT_EQ(map.balance.segments, map.balance.emitted);
  // Half of the photons survive their first hit: a binomial, 4 standard deviations.
  const auto emitted = static_cast<double>(map.balance.emitted);
  EXPECT_NEAR(static_cast<double>(map.balance.cutOff), 0.5 * emitted, 2.0 * std::sqrt(emitted));
  for (const double indirect : map.front.indirect)
  {
    EXPECT_EQ(indirect, 0.0);
  }
}

TEST(Transport, PathLengthLimitIsCounted)
{
  const Scene scene(Room(1.0f)); // nothing absorbs: only the limit ends a photon
  TraceSettings settings;
  settings.maximumPathLength = 50;
  const TracedMap map(scene, RoomLamp, settings, 2048);
  EXPECT_EQ(map.balance.cutOff, 2048u);
  EXPECT_EQ(map.balance.segments, 2048u * 50u);
  ExpectBalanced(map.balance);
}

TEST(Transport, RefusesSettingsThatMakeNoSense)
{
  const Scene scene(Room(0.5f));
  const auto refused = [&](const auto& spoil)
  {
    TraceSettings settings;
    spoil(settings);
    EXPECT_THROW(PhotonTracer(scene, RoomLamp, settings), InvalidInput);
  };
  refused([](TraceSettings& s) { s.replicates = 1; });
  refused([](TraceSettings& s) { s.weightBound = 0.5f; });
  refused([](TraceSettings& s) { s.weightBound = std::nanf(""); });
  refused([](TraceSettings& s) { s.maximumPathLength = 0; });
  refused([](TraceSettings& s) { s.threads = -1; });
}

TEST(Transport, RefusesALampSoFarThatEmbreeWouldEndTheProcess)
{
  const Scene scene(Room(0.5f));
  const TraceSettings settings;
  EXPECT_THROW(PhotonTracer(scene, PointLamp{ { 1e30, 0, 0 }, 1.0 }, settings), InvalidInput);
  EXPECT_THROW(PhotonTracer(scene, DiskLamp{ {}, { 0, 0, 1 }, 1e30, 1.0 }, settings), InvalidInput);
  EXPECT_NO_THROW(TracedMap(scene, PointLamp{ { 1e17, 0, 0 }, 1.0 }, settings, 1));
}

TEST(Transport, RefusesIlluminanceThatIsNoNumber)
{
  const Scene scene(Room(0.5f));
  const TraceSettings settings;
  EXPECT_THROW(PhotonTracer(scene, PointLamp{ {}, 1e306 }, settings), InvalidInput);
  EXPECT_THROW(PhotonTracer(scene, PointLamp{ {}, 1e-300 }, settings), InvalidInput);
  Surface vast = Room(0.5f);
  vast.metresPerUnit = 1e160;
  EXPECT_THROW(Scene{ vast }, InvalidInput);
}

TEST(ParallelFor, ComputesAsItsCallerDoes)
{
  // Embree first: it makes oneTBB's threads flush numbers below 2.2e-308 to zero.
  const Scene scene(Room(0.5f));
  std::vector<double> halves(10'000, std::numeric_limits<double>::min());
  ParallelFor(0, halves.size(),
    [&](std::uint64_t begin, std::uint64_t end)
    {
      for (std::uint64_t i = begin; i < end; ++i)
      {
        halves[i] *= 0.5;
      }
    });
  EXPECT_EQ(std::count(halves.begin(), halves.end(), 0.0), 0);
}
