// SPDX-License-Identifier: BSD-3-Clause
// The photon map: hits are those that the illumination map is of, whatever the run and its threads.
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint64_t Everything = std::numeric_limits<std::uint64_t>::max();
const Lamp RoomLamp = PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 };

Surface Room()
{
  return Shapes::WithReflectance(Shapes::RoomWithSphere(500), 0.5f);
}

/// The same with a pane, a mirror, gloss and lamp shades, in colours.
Surface RoomOfAllEffects()
{
  Surface room = Room();
  room.materials.assign(4, {});
  room.materials[0].diffuseReflectance = Colour(0.2f, 0.6f, 0.4f);
  room.materials[1].clearTransmittance = Colour(0.8f);
  room.materials[2].specularReflectance = Colour(0.7f);
  room.materials[3].glossyReflectance = Colour(0.3f);
  room.materials[3].diffuseTransmittance = Colour(0.3f);
  for (std::size_t f = 0; f < room.facets.size(); ++f)
  {
    room.materialOfFacet[f] = static_cast<std::uint32_t>(f % 4);
  }
  return room;
}

TraceSettings SettingsOf(Registration registration, int threads = 0)
{
  TraceSettings settings;
  settings.registration = registration;
  settings.registerBackSide = true;
  settings.threads = threads;
  return settings;
}

bool Same(const std::vector<PhotonHit>& a, const std::vector<PhotonHit>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const PhotonHit& x, const PhotonHit& y)
    {
      return x.photon == y.photon && x.facet == y.facet && x.barycentric == y.barycentric &&
        x.direction == y.direction && x.scatterings == y.scatterings && x.source == y.source &&
        x.shares == y.shares && x.front == y.front;
    });
}

double Luminous(const IlluminationMap& map, std::size_t v)
{
  return map.direct[v] + map.indirect[v];
}

/// Compares each vertex's E A with the sum of the hits' flux times barycentric coordinate.
void ExpectTheFlatMap(const Scene& scene, const IlluminationRun& run, const StoredPhotons& stored)
{
  const std::size_t vertices = scene.NumberOfMapVertices();
  std::array<std::vector<double>, 2> sums{ std::vector<double>(vertices, 0.0),
    std::vector<double>(vertices, 0.0) };
  std::vector<double> hits(vertices, 0.0);
  const double onePhoton = run.Flux() / static_cast<double>(stored.photons);
  double greatest = 0.0; // lm of a hit
  for (const PhotonHit& hit : stored.hits)
  {
    const double flux = onePhoton * double{ run.StartWeights()[hit.source] };
    greatest = std::max(greatest, flux);
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t v = scene.GivenVertices(hit.facet)[c];
      sums[hit.front ? 0 : 1][v] += flux * double{ hit.barycentric[c] };
      hits[v] += 1.0;
    }
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    // The map rounds each hit to 2^-28, and adds half a unit of a float of up to 1 before that.
    const double rounding = std::max(onePhoton, greatest) * hits[v] * 0x1p-23;
    EXPECT_NEAR(sums[0][v], Luminous(run.Front(), v) * scene.VertexAreas()[v], rounding) << v;
    EXPECT_NEAR(sums[1][v], Luminous(run.Back(), v) * scene.VertexAreas()[v], rounding) << v;
  }
}

} // namespace

TEST(PhotonFollower, AllHitsAreThoseOfTheFlatMap)
{
  for (const Surface& surface : { Room(), RoomOfAllEffects() })
  {
    const Scene scene(surface);
    IlluminationRun run(scene, RoomLamp, SettingsOf(Registration::Flat));
    run.Advance({ 20'000 });
    const StoredPhotons stored = run.Photons(Everything);
    const PhotonBalance balance = run.Balance();
    EXPECT_EQ(stored.photons, balance.emitted);
    EXPECT_EQ(stored.hits.size(), balance.segments - balance.escaped);
    ExpectTheFlatMap(scene, run, stored);
    EXPECT_EQ(run.Photons(stored.hits.size()).photons, balance.emitted) << "there is just room";
  }
}

// Photons that start at openings count by their start weights; those whose light comes by others
// have no hits, and no paths.
TEST(PhotonFollower, HitsOfLightThroughAWindowAreThoseOfTheFlatMap)
{
  const Surface room =
    Shapes::WithReflectance(Shapes::RoomWithWindow(4.0, 3.0, { -1.5, 0.5, 1.5, 2.5 }, 4), 0.5f);
  const Scene scene(room);
  const UniformSky sky{ { 0, 0, 1 }, 10'000.0, true };
  const TraceSettings settings = SettingsOf(Registration::Flat);
  const Openings window = OpeningsToSkies(room, scene, sky, settings).openings;
  ASSERT_FALSE(window.IsEmpty());
  IlluminationRun run(scene, sky, settings, window);
  run.Advance({ 40'000 });
  const StoredPhotons stored = run.Photons(Everything);
  EXPECT_EQ(stored.photons, run.Balance().emitted);
  std::set<float> weights;
  for (const PhotonHit& hit : stored.hits)
  {
    weights.insert(run.StartWeights()[hit.source]);
  }
  EXPECT_GT(weights.size(), 1u) << "or weights are not tested here";
  ExpectTheFlatMap(scene, run, stored);

  const std::vector<PhotonPath> paths = run.Paths(500);
  ASSERT_EQ(paths.size(), 500u);
  for (const PhotonPath& path : paths)
  {
    ASSERT_FALSE(path.hits.empty());
    // A photon flies from its start to its first hit, so both directions are one.
    EXPECT_GT(glm::dot(path.start.direction, path.hits.front().direction), 0.9999f);
  }
}

TEST(PhotonFollower, HitsComeInTheOrderOfPhotonsAndPaths)
{
  const Scene scene(RoomOfAllEffects());
  IlluminationRun run(scene, RoomLamp, SettingsOf(Registration::Flat));
  run.Advance({ 20'000 });
  const StoredPhotons stored = run.Photons(Everything);
  std::size_t photons = 0;
  for (std::size_t i = 0; i < stored.hits.size(); ++i)
  {
    const PhotonHit& hit = stored.hits[i];
    const bool isFirst = i == 0 || stored.hits[i - 1].photon != hit.photon;
    EXPECT_EQ(hit.scatterings, isFirst ? 0u : stored.hits[i - 1].scatterings + 1u);
    photons += isFirst ? 1 : 0;
  }
  EXPECT_LE(photons, stored.photons);
  EXPECT_GT(photons, stored.photons * 9 / 10) << "few leave a closed room through its panes";
}

TEST(PhotonFollower, HasTheSameBitsForAnyThreadsAndAnyRun)
{
  constexpr std::uint64_t Most = 30'000;
  const Scene scene(RoomOfAllEffects());
  IlluminationRun inOneGo(scene, RoomLamp, SettingsOf(Registration::VertexNormalised, 1));
  inOneGo.Advance({ 40'000 });
  const StoredPhotons stored = inOneGo.Photons(Most);
  IlluminationRun divided(scene, RoomLamp, SettingsOf(Registration::Flat, 3));
  divided.Advance({ 3'000 });
  const StoredPhotons fewer = divided.Photons(Most);
  EXPECT_EQ(fewer.photons, divided.Balance().emitted) << "all, which is less than the most";
  divided.Advance({ 40'000 });
  const StoredPhotons same = divided.Photons(Most);
  EXPECT_EQ(same.photons, stored.photons);
  EXPECT_TRUE(Same(same.hits, stored.hits));
  divided.Advance({ 80'000 });
  EXPECT_TRUE(Same(divided.Photons(Most).hits, stored.hits)) << "the first photons stay the first";
}

TEST(PhotonFollower, ThinsByWholePhotonsAndNeverHasMoreThanTheMost)
{
  const Scene scene(RoomOfAllEffects());
  IlluminationRun run(scene, RoomLamp, SettingsOf(Registration::Flat));
  run.Advance({ 20'000 });
  const StoredPhotons all = run.Photons(Everything);
  for (const std::uint64_t most : { 0u, 1u, 2u, 7u, 500u, 1000u, 5000u, 20'000u })
  {
    SCOPED_TRACE(most);
    const StoredPhotons some = run.Photons(most);
    ASSERT_LE(some.hits.size(), most);
    const std::vector<PhotonHit> first(
      all.hits.begin(), all.hits.begin() + static_cast<std::ptrdiff_t>(some.hits.size()));
    EXPECT_TRUE(Same(some.hits, first));
    std::uint64_t ofNext = 1;
    for (std::size_t i = some.hits.size() + 1; all.hits[i].scatterings > 0; ++i)
    {
      ++ofNext;
    }
    EXPECT_GT(some.hits.size() + ofNext, most) << "the next photon has no room";
    EXPECT_EQ(all.hits[some.hits.size()].scatterings, 0u) << "no path is cut";
  }
}

TEST(PhotonFollower, AThinnedMapHasTheFluxOfAll)
{
  const Scene scene(Room());
  TraceSettings settings = SettingsOf(Registration::Flat);
  settings.sampling = Sampling::Random; // the tolerance is that of independent photons
  IlluminationRun run(scene, RoomLamp, settings);
  run.Advance({ 400'000 });
  const StoredPhotons some = run.Photons(100'000);
  const PhotonBalance balance = run.Balance();
  const auto mean =
    static_cast<double>(balance.segments - balance.escaped) / static_cast<double>(balance.emitted);
  const double ofSome = static_cast<double>(some.hits.size()) / static_cast<double>(some.photons);
  // A photon survives each hit with probability 1/2: the number of hits has the variance 2.
  EXPECT_NEAR(ofSome, mean, 4.0 * std::sqrt(2.0 / static_cast<double>(some.photons)));
}

TEST(PhotonFollower, StopsWhenItIsTold)
{
  const Scene scene(Room());
  IlluminationRun run(scene, RoomLamp, SettingsOf(Registration::Flat, 1));
  run.Advance({ 100'000 });
  const StoredPhotons stopped =
    run.Photons(Everything, [](std::uint64_t hits) { return hits < 3000; });
  EXPECT_GE(stopped.hits.size(), 3000u);
  EXPECT_LT(stopped.photons, 20'000u);
  EXPECT_GT(stopped.photons, 0u) << "and what there is, is a map";
}

TEST(PhotonFollower, PathsAreThoseOfTheFirstPhotons)
{
  const Scene scene(RoomOfAllEffects());
  IlluminationRun run(scene, RoomLamp, SettingsOf(Registration::Flat));
  run.Advance({ 20'000 });
  const std::vector<PhotonPath> paths = run.Paths(300);
  ASSERT_EQ(paths.size(), 300u);
  // The first blocks of two replicates come in turn: 256 photons of the first are in both.
  const StoredPhotons stored = run.Photons(5'000);
  std::vector<PhotonHit> ofPaths;
  for (std::size_t photon = 0; photon < 256; ++photon)
  {
    ASSERT_FALSE(paths[photon].hits.empty());
    EXPECT_LT(glm::distance(glm::dvec3(paths[photon].start.origin),
                scene.GetPlacement().PointToScene({ -1.0, 0.5, 0.8 })),
      1e-5);
    for (const PhotonHit& hit : paths[photon].hits)
    {
      EXPECT_EQ(hit.photon, photon);
      if (hit.HasEscaped())
      {
        EXPECT_EQ(&hit, &paths[photon].hits.back());
      }
      else
      {
        ofPaths.push_back(hit);
      }
    }
  }
  ASSERT_GT(stored.hits.size(), ofPaths.size());
  EXPECT_TRUE(Same(ofPaths,
    { stored.hits.begin(), stored.hits.begin() + static_cast<std::ptrdiff_t>(ofPaths.size()) }));
  EXPECT_TRUE(IlluminationRun(scene, RoomLamp, SettingsOf(Registration::Flat)).Paths(10).empty())
    << "nothing has been traced";
}

TEST(PhotonFollower, FollowsThePhotonsOfFinalGathering)
{
  const Scene scene(Room());
  TraceSettings settings = SettingsOf(Registration::Flat);
  IlluminationRun tracing(scene, RoomLamp, settings);
  tracing.Advance({ 10'000 });
  settings.method = Method::FinalGathering;
  settings.gatherRays = LeastGatherRays;
  IlluminationRun gathering(scene, RoomLamp, settings);
  gathering.Advance({ 10'000 });
  EXPECT_TRUE(Same(tracing.Photons(Everything).hits, gathering.Photons(Everything).hits));
}
