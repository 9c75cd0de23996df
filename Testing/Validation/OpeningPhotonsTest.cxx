// SPDX-License-Identifier: BSD-3-Clause
// Photon tracing through openings: the light is the same as without them, and the errors that are
// told are right.
#include "Shapes.h"
#include "TracedMap.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr double Half = 2.0, Height = 3.0; ///< m

Material Matt(float red, float green, float blue)
{
  Material material;
  material.diffuseReflectance = { red, green, blue };
  return material;
}

Surface With(Surface surface, const Material& material)
{
  surface.materials = { material };
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  return surface;
}

/// A room with a window in the wall y = 2, the ground before it, a mirror that stands there, and a
/// pane in the window or not.
Surface RoomAndGround(bool pane, bool coloured)
{
  const float blue = coloured ? 0.2f : 0.6f;
  Surface all = With(
    Shapes::RoomWithWindow(2.0 * Half, Height, { -1.5, 0.5, 1.5, 2.5 }, 4), Matt(0.6f, 0.6f, blue));
  all = Shapes::Together(all,
    With(Shapes::Rectangle({ -3, Half, 0 }, { 6, 0, 0 }, { 0, 3, 0 }, 3), Matt(0.5f, blue, blue)));
  Material mirror;
  mirror.specularReflectance = Colour(0.7f);
  mirror.diffuseReflectance = Colour(0.2f);
  all = Shapes::Together(
    all, With(Shapes::Rectangle({ -3, 5, 0 }, { 6, 0, 0 }, { 0, 0, 2 }, 2), mirror));
  if (pane)
  {
    Material glass;
    glass.clearTransmittance = Colour(0.9f);
    glass.refractiveIndex = 1.5f;
    all = Shapes::Together(
      all, With(Shapes::Rectangle({ -1.5, Half, 0.5 }, { 3, 0, 0 }, { 0, 0, 2 }, 1), glass));
  }
  return all;
}

/// Two skies, the sun and a lamp in the room.
Lighting AllLamps(bool coloured)
{
  Lighting lighting;
  lighting.luminaires = { { CieSky{ { 0, 0, 1 }, 12, glm::dvec3(0.3, 1.0, 0.7), 10'000.0 }, "Sky",
                            Colour(1.0f) },
    { UniformSky{ { 0, 0, 1 }, 300.0, true }, "Haze", Colour(1.0f) },
    { ParallelLight{ { -0.3, -1.0, -0.7 }, 20'000.0 }, "Sun", Colour(1.0f) },
    { PointLamp{ { 0.5, -0.5, 2.0 }, 5000.0 }, "Lamp", Colour(1.0f) } };
  if (coloured)
  {
    lighting.luminaires[0].colour = { 0.5f, 0.8f, 1.2f };
  }
  return lighting;
}

Opening Polygon(
  const Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
  const auto at = [&](double s, double t)
  { return glm::vec3(scene.GetPlacement().PointToScene(corner + s * u + t * v)); };
  return MakeOpening({ { at(0, 0), at(1, 0), at(1, 1) }, { at(0, 0), at(1, 1), at(0, 1) } },
    glm::vec3(glm::normalize(glm::cross(u, v))), OpeningKind::Hole);
}

using Row = std::vector<double>;

/// Sums over groups of vertices of all that a map says: direct and indirect light, of each lamp, of
/// each colour.
Row Summary(const TracedMap& map)
{
  const auto group = [&](std::size_t v) -> std::size_t
  {
    const glm::dvec3 normal(map.scene.Vertices()[v].normal);
    const glm::dvec3 p(map.scene.Vertices()[v].position);
    const glm::dvec3 place = p / map.scene.GetPlacement().scale + map.scene.GetPlacement().centre;
    const std::size_t side = normal.z > 0.5 ? 0
      : normal.z < -0.5                     ? 1
      : std::fabs(normal.x) > 0.5           ? 2
                                            : 3;
    return side + (place.y > Half - 1e-6 ? 4 : 0);
  };
  constexpr std::size_t GroupsOfPoints = 8;
  const std::size_t layers = 2 + map.frontOfLamps.size() + (map.frontByColour.empty() ? 0 : 3);
  Row sums(GroupsOfPoints * layers, 0.0);
  for (std::size_t v = 0; v < map.front.direct.size(); ++v)
  {
    const double area = map.scene.VertexAreas()[v];
    double* own = &sums[group(v) * layers];
    *own++ += area * map.front.direct[v];
    *own++ += area * map.front.indirect[v];
    for (const std::vector<double>& lamp : map.frontOfLamps)
    {
      *own++ += area * lamp[v];
    }
    for (std::size_t c = 0; c < 3 && !map.frontByColour.empty(); ++c)
    {
      *own++ += area * map.frontByColour[v][c];
    }
  }
  return sums;
}

std::vector<ReplicateStatistics> Means(const Scene& scene, const Lighting& lighting,
  TraceSettings settings, std::uint64_t photons, const Openings& openings, std::uint32_t runs)
{
  std::vector<ReplicateStatistics> means;
  for (std::uint32_t run = 0; run < runs; ++run)
  {
    settings.seed = 1 + run;
    const Row row = Summary(TracedMap(scene, lighting, settings, photons, openings));
    means.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      means[i].Add(row[i], 1.0);
    }
  }
  return means;
}

/// Expects two sets of independent means to agree: each within 5 standard errors (Student's t with
/// some 30 degrees of freedom exceeds them in 2 of 10^5 draws), and their mean square as that of t.
void ExpectAgreement(
  const std::vector<ReplicateStatistics>& a, const std::vector<ReplicateStatistics>& b)
{
  double squares = 0.0, number = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const double error = std::hypot(a[i].StandardError(), b[i].StandardError());
    if (!(error > 0.0))
    {
      EXPECT_EQ(a[i].Mean(), b[i].Mean()) << i;
      continue;
    }
    const double z = (a[i].Mean() - b[i].Mean()) / error;
    EXPECT_LT(std::fabs(z), 5.0) << i << ": " << a[i].Mean() << ", " << b[i].Mean();
    squares += z * z;
    number += 1.0;
  }
  testing::Test::RecordProperty("meanSquare", std::to_string(squares / number));
  EXPECT_LT(squares / number, 1.8); // of some 50 quantities, many of which are nearly the same
}

struct SameLight
{
  const char* name;
  bool pane, coloured, backSide;
  /// 0: the window as it is found, 1: two more polygons in line, one of them across the window.
  int polygons;
};

class WithAndWithout : public testing::TestWithParam<SameLight>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(OpeningPhotons, WithAndWithout,
  testing::Values(SameLight{ "Hole", false, false, false, 0 },
    SameLight{ "PaneInColours", true, true, false, 0 },
    SameLight{ "TwoInLine", false, false, true, 1 }),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST_P(WithAndWithout, TheLightIsTheSame)
{
  const SameLight& what = GetParam();
  const Surface surface = RoomAndGround(what.pane, what.coloured);
  const Scene scene(surface);
  const Lighting lighting = AllLamps(what.coloured);
  TraceSettings settings;
  settings.replicates = 2;
  settings.lampsApart = true;
  settings.registerBackSide = what.backSide;
  std::vector<Opening> polygons =
    OpeningsToSkies(surface, scene, lighting, settings).openings.List();
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_LT(polygons.front().normal.y, -0.99f); // inwards
  if (what.polygons == 1)
  {
    polygons.push_back(Polygon(scene, { 1.2, 3, 0.2 }, { -3, 0, 0.4 }, { 0, 0, 1.5 }));
    polygons.push_back(Polygon(scene, { 1.2, 1.2, 1.1 }, { -2, 0, 0 }, { 0, 1.7, 0.4 }));
  }
  constexpr std::uint32_t Runs = 32;
  ExpectAgreement(Means(scene, lighting, settings, 1u << 14, Openings(polygons), Runs),
    Means(scene, lighting, settings, 1u << 15, Openings(), Runs));
}

TEST(OpeningPhotons, BalanceInNumbersAndInFlux)
{
  const Surface surface = RoomAndGround(true, true);
  const Scene scene(surface);
  const Lighting lighting = AllLamps(true);
  TraceSettings settings;
  IlluminationRun run(
    scene, lighting, settings, OpeningsToSkies(surface, scene, lighting, settings).openings);
  run.Advance({ 1u << 18 });
  const PhotonBalance balance = run.Balance();
  EXPECT_GT(balance.handedOver, 0u);
  EXPECT_GT(balance.blocked, 0u);
  EXPECT_EQ(balance.emitted,
    balance.absorbed + balance.escaped + balance.cutOff + balance.handedOver + balance.blocked);
  Arrivals arrivals;
  ArrivedFlux flux;
  for (const Arrivals& lamp : run.ArrivalsByLamp())
  {
    arrivals += lamp;
  }
  for (const ArrivedFlux& lamp : run.FluxArrivedByLamp())
  {
    flux += lamp;
  }
  EXPECT_EQ(balance.emitted, arrivals.Emitted() + arrivals.elsewhere);
  // All light arrives somewhere or escapes: what is handed over at the window starts there.
  EXPECT_NEAR(flux.Emitted() / run.Flux(), 1.0, 0.003);
  const FluxBalance all = run.BalanceOfFlux();
  EXPECT_NEAR((all.absorbed + all.escaped + all.cutOff) / run.Flux(), 1.0, 0.003);
}

// The ground sends light to the outside of the room's walls, which are backs. That is as it should
// be and no reason to doubt the normals, where photons tell outdoors from indoors. A floor that
// looks down is still found.
TEST(OpeningPhotons, ScatteredLightOutdoorsIsNotMissing)
{
  const Surface sound = RoomAndGround(false, false);
  Surface turned = sound;
  for (std::size_t v = 0; v < turned.normals.size(); ++v)
  {
    const bool onFloor = turned.points[v].z == 0.0 && turned.points[v].y < Half;
    turned.normals[v] *= onFloor && turned.normals[v].z > 0.5f ? -1.0f : 1.0f;
  }
  const Lighting lighting(CieSky{ { 0, 0, 1 }, 16, { 0, 1, 1 }, 10'000.0 });
  const TraceSettings settings;
  const auto onBacks = [&](const Surface& surface, bool known)
  {
    const Scene scene(surface);
    IlluminationRun run(scene, lighting, settings,
      known ? OpeningsToSkies(surface, scene, lighting, settings).openings : Openings());
    run.Advance({ 1u << 17 });
    return run.ScatteredLightOnBacks();
  };
  EXPECT_LT(onBacks(sound, true).Value(), 0.01); // it has left by the window
  EXPECT_FALSE(onBacks(sound, true).SurelyExceeds(0.1));
  EXPECT_GT(onBacks(sound, false).Value(), 0.08);
  EXPECT_TRUE(onBacks(turned, true).SurelyExceeds(0.1));
}

TEST(OpeningPhotons, SameBitsForAnyThreadsAndDivision)
{
  const Surface surface = RoomAndGround(true, true);
  const Scene scene(surface);
  const Lighting lighting = AllLamps(true);
  TraceSettings settings;
  settings.lampsApart = true;
  const Openings openings = OpeningsToSkies(surface, scene, lighting, settings).openings;
  const TracedMap expected(scene, lighting, settings, 1u << 15, openings);
  for (const int threads : { 1, 3 })
  {
    settings.threads = threads;
    EXPECT_TRUE(TracedMap(scene, lighting, settings, 1u << 15, openings).HasTheBitsOf(expected));
  }
  IlluminationRun run(scene, lighting, settings, openings);
  run.Advance({ 1u << 12 });
  run.Advance({ 1u << 15 });
  EXPECT_EQ(run.Front().direct, expected.front.direct);
  EXPECT_EQ(run.Front().indirect, expected.front.indirect);
  EXPECT_EQ(run.Front().standardError, expected.front.standardError);
}

TEST(OpeningPhotons, ErrorsAreAsTold)
{
  const Surface surface = RoomAndGround(true, false);
  const Scene scene(surface);
  const Lighting lighting(CieSky{ { 0, 0, 1 }, 16, { 0, 1, 1 }, 10'000.0 });
  TraceSettings settings;
  const Openings openings = OpeningsToSkies(surface, scene, lighting, settings).openings;
  constexpr std::uint32_t Runs = 40;
  std::vector<Row> lux, errors;
  for (std::uint32_t run = 0; run < Runs; ++run)
  {
    settings.seed = 1 + run;
    const TracedMap map(scene, lighting, settings, 1u << 14, openings);
    lux.push_back(map.front.direct);
    std::transform(lux.back().begin(), lux.back().end(), map.front.indirect.begin(),
      lux.back().begin(), std::plus<>());
    errors.push_back(map.front.standardError);
  }
  double squares = 0.0, number = 0.0, beyond = 0.0;
  for (std::size_t v = 0; v < lux.front().size(); ++v)
  {
    double mean = 0.0;
    for (const Row& row : lux)
    {
      mean += row[v] / Runs;
    }
    for (std::uint32_t run = 0; run < Runs && mean > 0.0; ++run)
    {
      // The mean holds this run, too, which makes the difference smaller.
      const double z = (lux[run][v] - mean) / errors[run][v] / std::sqrt(1.0 - 1.0 / Runs);
      squares += z * z;
      beyond += std::fabs(z) > 3.0 ? 1.0 : 0.0;
      number += 1.0;
    }
  }
  // Student's t with 7 degrees of freedom has the mean square 1.4 and is beyond 3 in 2 % of draws.
  testing::Test::RecordProperty("meanSquare", std::to_string(squares / number));
  EXPECT_GT(squares / number, 0.8);
  EXPECT_LT(squares / number, 1.6);
  EXPECT_LT(beyond / number, 0.03);
}

namespace
{

/// A map as photons bring it, and smoothed by its two parts in groups.
struct SmoothedRun
{
  Row before, standardError, after, squaredError;

  SmoothedRun(const Surface& surface, const Scene& scene, const Openings& openings,
    std::uint32_t seed, std::uint64_t photons)
  {
    const Lighting lighting(CieSky{ { 0, 0, 1 }, 16, { 0, 1, 1 }, 10'000.0 });
    TraceSettings settings;
    settings.seed = seed;
    IlluminationRun run(scene, lighting, settings, openings);
    run.Advance({ photons });
    const IlluminationMap map = run.Front();
    const GroupMeans groups = run.FrontByGroups();
    const std::vector<FilteredMap> parts =
      Filtrate(SmoothingGraph(surface.points, surface.facets, 0.7),
        { { "direct", map.direct, groups.direct, {} },
          { "indirect", map.indirect, groups.indirect, {} } },
        Row(map.photonHits.begin(), map.photonHits.end()), {}, [](double) {});
    for (std::size_t v = 0; v < map.direct.size(); ++v)
    {
      this->before.push_back(map.direct[v] + map.indirect[v]);
      this->standardError.push_back(map.standardError[v]);
      this->after.push_back(parts[0].values[v] + parts[1].values[v]);
      this->squaredError.push_back(parts[0].squaredError[v] + parts[1].squaredError[v]);
    }
  }
};

} // namespace

// The truth is what very many photons bring, so that the size of facets, which smoothing knows
// nothing of, is no error. Kernels level the slope of light at the edges of walls; that is told,
// too.
TEST(OpeningPhotons, ErrorsOfSmoothedMapsAreAsTold)
{
  const Surface surface =
    Shapes::Together(With(Shapes::RoomWithWindow(2.0 * Half, Height, { -1.5, 0.5, 1.5, 2.5 }, 16),
                       Matt(0.6f, 0.6f, 0.6f)),
      With(
        Shapes::Rectangle({ -8, Half, 0 }, { 16, 0, 0 }, { 0, 16, 0 }, 8), Matt(0.2f, 0.2f, 0.2f)));
  const Scene scene(surface);
  const Lighting lighting(CieSky{ { 0, 0, 1 }, 16, { 0, 1, 1 }, 10'000.0 });
  const Openings openings = OpeningsToSkies(surface, scene, lighting, {}).openings;
  ASSERT_EQ(openings.List().size(), 1u);
  const SmoothedRun truth(surface, scene, openings, 1000, 1u << 23);
  const auto sides = [](const glm::dvec3& p)
  {
    return (std::fabs(std::fabs(p.x) - Half) < 1e-9 ? 1 : 0) +
      (std::fabs(std::fabs(p.y) - Half) < 1e-9 ? 1 : 0) +
      (std::fabs(p.z) < 1e-9 || std::fabs(p.z - Height) < 1e-9 ? 1 : 0);
  };
  double squares[2] = {}, told[2] = {};
  for (std::uint32_t seed = 1; seed <= 8; ++seed)
  {
    const SmoothedRun run(surface, scene, openings, seed, 1u << 17);
    for (std::size_t v = 0; v < run.after.size(); ++v)
    {
      if (surface.points[v].y <= Half)
      {
        const int place = sides(surface.points[v]) > 1 ? 1 : 0;
        squares[place] += std::pow(run.after[v] - truth.before[v], 2);
        told[place] += run.squaredError[v] + std::pow(truth.standardError[v], 2);
      }
    }
  }
  for (const int place : { 0, 1 })
  {
    const double ratio = std::sqrt(told[place] / squares[place]);
    testing::Test::RecordProperty(place == 1 ? "edges" : "walls", std::to_string(ratio));
    EXPECT_GT(ratio, 0.88) << (place == 1 ? "at edges" : "within walls");
    EXPECT_LT(ratio, 1.4) << (place == 1 ? "at edges" : "within walls");
  }
}
