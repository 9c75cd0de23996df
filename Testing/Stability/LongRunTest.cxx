// SPDX-License-Identifier: BSD-3-Clause
// Cases 5, 6, 8 and 9: leaks, long paths, sums, threads and order.
#include "CoreTools.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

using Case5 = EveryWay;
using Case6 = EveryWay;
using Case8Flux = EveryWay;
using Case9 = EveryWay;

Shapes::Surface Room(float reflectance)
{
  return Shapes::WithReflectance(Shapes::RoomWithSphere(2000), reflectance);
}

const Lamp RoomLamp = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };

} // namespace

INSTANTIATE_TEST_SUITE_P(Stability, Case5, AllWays(), NameOfWay);
INSTANTIATE_TEST_SUITE_P(Stability, Case6, AllWays(), NameOfWay);
INSTANTIATE_TEST_SUITE_P(Stability, Case8Flux, AllWays(), NameOfWay);
INSTANTIATE_TEST_SUITE_P(Stability, Case9, AllWays(), NameOfWay);

TEST_P(Case5, ClosedShapesDoNotLeak)
{
  struct Shape
  {
    Shapes::Surface surface;
    glm::dvec3 lamp;
  };
  const Shape shapes[] = { { Shapes::Box({ -2, -1, 0 }, { 2, 1, 1.5 }, 6, Facing::Inward),
                             { 0.5, 0.2, 1.2 } },
    { Shapes::Icosphere(3, Facing::Inward), { 0.5, 0.2, -0.3 } },
    { Shapes::Torus(40, 16, Facing::Inward), { 0.9, 0.1, 0.2 } },
    { Shapes::Wedge(20.0, Facing::Inward), { 0.6, 0.1, 0.4 } },
    { Shapes::Icosphere(LongTests() ? 8 : 6, Facing::Inward), { 0.5, 0.2, -0.3 } } };
  TraceSettings settings = GetParam().Settings();
  settings.maximumPathLength = 1'000'000; // of 22 thousand photons one goes on beyond 10 thousand
  std::uint64_t segments = 0;
  for (const Shape& shape : shapes)
  {
    const TracedMap run(Shapes::WithReflectance(shape.surface, 0.999f),
      PointLamp{ shape.lamp, 1000.0 }, settings, LongTests() ? 200'000 : 2'000);
    segments += run.balance.segments;
    EXPECT_EQ(run.balance.escaped, 0u);
    EXPECT_EQ(run.balance.cutOff, 0u);
    EXPECT_EQ(run.RegisteredFlux(run.back), 0.0) << "light on the outside";
  }
  // A photon has 1000 segments, give or take 1000: the mean over thousands is within a tenth.
  EXPECT_GT(segments, LongTests() ? 900'000'000u : 9'000'000u);
  Report("light leaking through edges and corners",
    std::to_string(segments) + " segments at reflectance 0.999: none escaped, none outside");
}

// Hits of a photon: geometric with mean 1 / (1 - rho) and variance rho / (1 - rho)^2.
TEST_P(Case6, LongPathsEndAndAddUp)
{
  const Shapes::Surface sphere = Shapes::Octasphere(4, Facing::Inward);
  double largest = 0.0;
  for (const float reflectance : { 0.95f, 0.99f, 0.999f })
  {
    const TracedMap run(Shapes::WithReflectance(sphere, reflectance),
      PointLamp{ { 0.3, 0.2, 0.1 }, 1000.0 }, GetParam().Settings(), 6'000);
    const double rho = reflectance;
    const double emitted = static_cast<double>(run.balance.emitted);
    const double expected = 1.0 / (1.0 - rho);
    const double measured = static_cast<double>(run.balance.segments) / emitted;
    const double error = expected * std::sqrt(rho / emitted);
    EXPECT_NEAR(measured, expected, 4.0 * error) << "reflectance " << reflectance;
    EXPECT_EQ(run.balance.cutOff, 0u);
    largest = std::max(largest, std::fabs(measured - expected) / error);
  }
  char text[96];
  std::snprintf(
    text, sizeof(text), "reflectance 0.95 to 0.999: at most %.1f standard errors off", largest);
  Report("photons that go on for ever or end too soon", text);
}

TEST_P(Case6, NothingAbsorbsAndTheRunStillEnds)
{
  TraceSettings settings = GetParam().Settings();
  settings.maximumPathLength = 1000;
  const TracedMap run(Room(1.0f), RoomLamp, settings, 2048);
  EXPECT_EQ(run.balance.cutOff, run.balance.emitted);
  EXPECT_EQ(run.balance.segments, 1000 * run.balance.emitted);
  Report(
    "a run without end where nothing absorbs", "all photons cut off after 1000 segments, counted");
}

TEST(Case8, AThousandMillionHitsWithoutDrift)
{
  // Weights of 24 bits, as many as a float has, differ from hit to hit; their sum is known exactly.
  constexpr std::uint32_t Hits = 1'000'000'000;
  FixedPoint sum = 0;
  std::uint64_t exact = 0; // of 2^-24
  std::uint32_t random = 1;
  for (std::uint32_t hit = 0; hit < Hits; ++hit)
  {
    random = 1664525u * random + 1013904223u;
    const std::uint32_t weight = random >> 8;
    sum += ToFixedPoint(static_cast<float>(weight) * 0x1p-24f);
    exact += weight;
  }
  EXPECT_EQ(FromFixedPoint(sum), static_cast<double>(exact) * 0x1p-24);
  Report("sums that drift with the number of hits", "10^9 hits: exact to the last bit");
}

TEST(Case8, PhotonsBeyondTheLimitAreRefused)
{
  StopRules rules;
  rules.photons = 10'000'000'001;
  try
  {
    Validate(rules);
    ADD_FAILURE() << "accepted";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_STREQ(
      error.what(), "the number of photons is 10000000001; it must be between 1 and 10000000000");
  }
  rules.photons = 10'000'000'000;
  EXPECT_NO_THROW(Validate(rules));
  Report("numbers of photons that no sum can hold", "more than 10^10 refused");
}

TEST(Case8, SumsEndARunBeforeTheyOverflow)
{
  ReplicateSums sums(8, IlluminationSums(3, true));
  EXPECT_FALSE(sums.AreFull());
  for (std::size_t r = 0; r < 8; ++r)
  {
    IlluminationSums replicate(3, true);
    replicate.front[1].direct = (FixedPoint{ 1 } << 57) - 1; // 16 of them are 2^61
    replicate.front[1].indirect = (FixedPoint{ 1 } << 57);
    sums.Add(r, replicate);
  }
  EXPECT_FALSE(sums.AreFull());
  IlluminationSums more(3, true);
  more.front[1].direct = 8;
  sums.Add(5, more);
  EXPECT_TRUE(sums.AreFull());
  sums.front = SideSums(3, 8, 4);
  EXPECT_FALSE(sums.AreFull());
  more.back[2].indirect = FixedPoint{ 1 } << 61;
  sums.Add(2, more);
  EXPECT_TRUE(sums.AreFull()) << "the back too";
  // A round at most triples the photons.
  EXPECT_LT(3.0 * 0x1p61, 0x1p63);
  Report("an overflow of the sums", "a run ends before three times its hits could overflow");
}

TEST_P(Case8Flux, FluxScalesTheMapAndNothingElse)
{
  const TracedMap one(
    Room(0.5f), PointLamp{ { -1.0, 0.5, 0.8 }, 1.0 }, GetParam().Settings(), 20'000);
  double largest = 0.0;
  for (const double flux : { 1e-12, 1e-3, 1e12 })
  {
    const TracedMap run(
      Room(0.5f), PointLamp{ { -1.0, 0.5, 0.8 }, flux }, GetParam().Settings(), 20'000);
    for (std::size_t v = 0; v < run.front.direct.size(); ++v)
    {
      const double expected = flux * one.front.direct[v];
      const double off =
        expected > 0.0 ? std::fabs(run.front.direct[v] / expected - 1.0) : run.front.direct[v];
      largest = std::max(largest, off);
    }
  }
  EXPECT_LE(largest, 4 * 0x1p-53); // three products and one quotient
  Report(
    "numbers that vanish in dim or bright scenes", "1e-12 to 1e12 lm: the same map to 4 roundings");
}

TEST_P(Case9, SixtyFourThreadsGiveTheSameBits)
{
  TraceSettings settings = GetParam().Settings();
  const TracedMap few(Room(0.6f), RoomLamp, settings, 50'000);
  for (const int threads : { 3, 8, 64 })
  {
    settings.threads = threads;
    const TracedMap many(Room(0.6f), RoomLamp, settings, 50'000);
    EXPECT_EQ(many.front.direct, few.front.direct) << threads;
    EXPECT_EQ(many.front.indirect, few.front.indirect) << threads;
    EXPECT_EQ(many.front.standardError, few.front.standardError) << threads;
  }
  Report("results that depend on the machine's threads", "1, 2, 3, 8, 64 threads: the same bits");
}

// Another order of cells and points changes which way the BVH breaks ties and where facets start
// their random numbers, so the map is another estimate of the same light.
TEST_P(Case9, OrderChangesTheMapByNoMoreThanNoise)
{
  const Shapes::Surface surface = Room(0.6f);
  std::mt19937 random(1);
  std::vector<unsigned> place(surface.points.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  Shapes::Surface shuffled = surface;
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    shuffled.points[place[p]] = surface.points[p];
    shuffled.normals[place[p]] = surface.normals[p];
  }
  for (glm::uvec3& facet : shuffled.facets)
  {
    facet = { place[facet.z], place[facet.x], place[facet.y] };
  }
  std::shuffle(shuffled.facets.begin(), shuffled.facets.end(), random);
  const TracedMap first(surface, RoomLamp, GetParam().Settings(), 100'000);
  TraceSettings other = GetParam().Settings();
  other.seed = 2; // or both would share most of their noise
  const TracedMap second(shuffled, RoomLamp, other, 100'000);
  double squares = 0.0;
  double variances = 0.0;
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    const std::size_t q = place[p];
    const double difference = first.front.direct[p] + first.front.indirect[p] -
      second.front.direct[q] - second.front.indirect[q];
    const double area = first.scene.VertexAreas()[p];
    squares += std::pow(area * difference, 2);
    variances += std::pow(area * first.front.standardError[p], 2) +
      std::pow(area * second.front.standardError[q], 2);
  }
  // Of n vertices a third are independent, and errors are known from 2 x 7 degrees of freedom.
  const double independent = static_cast<double>(place.size()) / 3.0;
  const double spread = std::sqrt((2.0 + 2.0 / 14.0) / independent);
  EXPECT_NEAR(squares / variances, 1.0, 5.0 * spread);
  char text[80];
  std::snprintf(text, sizeof(text), "squared difference %.2f of its expectation, spread %.2f",
    squares / variances, spread);
  Report("a map that depends on the order in the file", text);
}
