// SPDX-License-Identifier: BSD-3-Clause
// Light at a point by shadow rays, of triangles that shine and of many lamps.
#include "DirectLightRig.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = References::Pi;
constexpr double FloatRounding = 2e-5;

Surface Walls()
{
  return Shapes::Box(glm::dvec3(-4.0), glm::dvec3(4.0), 1, Facing::Inward);
}

EmittingMesh MeshOf(const Surface& surface, float exitance)
{
  EmittingMesh mesh;
  mesh.points = surface.points;
  mesh.facets = surface.facets;
  mesh.exitance.assign(surface.facets.size(), exitance);
  return mesh;
}

void ExpectOnAverage(const DirectLightRig& rig, const glm::dvec3& point, const glm::dvec3& normal,
  double exact, double most)
{
  const MeanOfSeeds all =
    Repeat([&](std::uint32_t seed) { return rig.At(point, normal, 16, seed); }, 400);
  EXPECT_NEAR(all.mean, exact, 4.5 * all.standardError + FloatRounding * most)
    << "at (" << point.x << ", " << point.y << ", " << point.z << ")";
  const MeanOfSeeds single = RepeatSamples(rig, point, normal, 4000);
  EXPECT_NEAR(single.mean, exact, 4.5 * single.standardError + FloatRounding * most)
    << "at (" << point.x << ", " << point.y << ", " << point.z << ")";
}

const std::vector<std::pair<glm::dvec3, glm::dvec3>> Receivers{
  { { 0.1, 0.1, 1e-4 }, { 0, 0, -1 } }, { { 0.3, -0.2, 0.02 }, { 0.3, 0.1, -1 } },
  { { -0.2, 0.5, 0.3 }, { 0.8, -0.3, -0.2 } }, { { 0.9, 0.6, 0.1 }, { -1, 0.2, -0.1 } },
  { { 0.2, 0.2, 2.0 }, { 0.1, 0, -1 } }, { { 0.2, 0.2, 0.2 }, { 0, 0, 1 } },
  { { 0.2, 0.2, -0.2 }, { 0, 0, 1 } }, // behind
};

} // namespace

TEST(DirectLight, OfATriangleIsLamberts)
{
  Surface triangle;
  triangle.points = { { -0.5, -0.4, 0 }, { 0.7, -0.3, 0 }, { 0.1, 0.6, 0 } };
  triangle.facets = { { 0, 1, 2 } };
  const DirectLightRig rig(Walls(), MeshOf(triangle, 50.0f));
  for (const auto& [point, direction] : Receivers)
  {
    const glm::dvec3 normal = glm::normalize(direction);
    const double exact = point.z > 0.0 ? 50.0 * UnitExitance(point, normal, triangle.points) : 0.0;
    ExpectOnAverage(rig, point, normal, exact, 100.0);
  }
}

// The scene's own facets: the ray must end at the facet without meeting it, and a wall that shines
// lights the others only.
TEST(DirectLight, OfTheScenesOwnFacets)
{
  const Surface panel =
    Shapes::WithExitance(Shapes::Rectangle({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2), 50.0f);
  const DirectLightRig rig(Shapes::Together(Walls(), panel), EmittingFacets{});
  const std::vector<glm::dvec3> corners{ { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } };
  for (const auto& [point, direction] : Receivers)
  {
    const glm::dvec3 normal = glm::normalize(direction);
    const double exact = point.z > 0.0 ? 50.0 * UnitExitance(point, normal, corners) : 0.0;
    ExpectOnAverage(rig, point, normal, exact, 100.0);
  }
  // On the panel itself, where rays start that leave it.
  const glm::vec3 start = rig.scene.SafeOrigin(12, glm::vec3(1.0f / 3.0f), true);
  DirectResult result;
  rig.light.At({ { 0, 0, 1 }, { { start, { 0, 0, 1 } } } }, 16, 1, 1, result);
  EXPECT_EQ(Total(result), 0.0);
}

// 5000 triangles, of which a few are drawn, are the quad that they make up.
TEST(DirectLight, OfManyTrianglesIsThatOfTheirQuad)
{
  const Surface quad = Shapes::Rectangle({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 50);
  ASSERT_EQ(quad.facets.size(), 5000u);
  const DirectLightRig rig(Walls(), MeshOf(quad, 50.0f));
  const std::vector<glm::dvec3> corners{ { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } };
  for (const auto& [point, direction] : Receivers)
  {
    const glm::dvec3 normal = glm::normalize(direction);
    const double exact = point.z > 0.0 ? 50.0 * UnitExitance(point, normal, corners) : 0.0;
    const MeanOfSeeds all =
      Repeat([&](std::uint32_t seed) { return rig.At(point, normal, 16, seed); }, 400);
    EXPECT_NEAR(all.mean, exact, 4.5 * all.standardError + FloatRounding * 50.0);
    EXPECT_LT(std::sqrt(all.spread), 0.12 * exact + 1e-9);
  }
}

// Lamps of all kinds, more than are sampled one by one: each gets its own light.
TEST(DirectLight, OfManyLampsIsTheSumOfEach)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  const auto place = [&] { return glm::dvec3(uniform(random), uniform(random), 2.5); };
  Lighting all;
  for (int i = 0; i < 6; ++i)
  {
    all.luminaires.push_back({ PointLamp{ place(), 100.0 }, {}, Colour(1.0f) });
    all.luminaires.push_back(
      { SpotLamp{ place(), { 0.1, 0, -1 }, 0.9, 2.0, 300.0 }, {}, Colour(1, 0.5f, 0.1f) });
    all.luminaires.push_back(
      { RectangleLamp{ place(), { 0, 0.1, -1 }, 0.5, 0.3, 200.0 }, {}, Colour(0.5f, 1, 0.1f) });
    all.luminaires.push_back({ LineLamp{ place(), { 1, 1, 0 }, 1.0, 100.0 }, {}, Colour(1.0f) });
  }
  all.luminaires.push_back(
    { ParallelLight{ { 0.1, 0.2, -1 }, 30.0 }, "Sun", Colour(1.0f, 0.9f, 0.8f) });
  const Surface floor = Shapes::Rectangle({ -4, -4, -1 }, { 8, 0, 0 }, { 0, 8, 0 }, 1);
  const DirectLightRig rig(floor, all, true);
  const glm::dvec3 point(0.3, -0.2, 0.0), normal = glm::normalize(glm::dvec3(0.2, 0.1, 1.0));
  constexpr std::uint32_t Seeds = 2000;
  std::vector<std::array<glm::dvec3, 2>> sums(all.luminaires.size()); // of light and its square
  std::vector<double> once(all.luminaires.size(), 0.0);
  MeanOfSeeds whole;
  double square = 0.0, single = 0.0, squareOfSingle = 0.0;
  std::mt19937_64 numbers(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
  {
    const DirectResult result = rig.At(point, normal, 16, seed);
    for (std::size_t lamp = 0; lamp < sums.size(); ++lamp)
    {
      const glm::dvec3 light(result.ofLamp[lamp]);
      sums[lamp][0] += light / double{ Seeds };
      sums[lamp][1] += light * light / double{ Seeds };
    }
    whole.mean += Total(result) / Seeds;
    square += Total(result) * Total(result) / Seeds;
    whole.toldVariance += result.variance / Seeds;
    std::uint32_t lamp = 0;
    const double one =
      glm::dot(glm::dvec3(rig.light.Sample(rig.ReceiverAt(point, normal), unit(numbers), lamp)),
        glm::dvec3(1.0));
    single += one / Seeds;
    squareOfSingle += one * one / Seeds;
  }
  double exact = 0.0;
  for (std::size_t lamp = 0; lamp < sums.size(); ++lamp)
  {
    const DirectLightRig alone(
      floor,
      [&]
      {
        Lighting lighting;
        lighting.luminaires.push_back(all.luminaires[lamp]);
        return lighting;
      }(),
      true);
    const DirectResult wanted = alone.At(point, normal, 4096);
    exact += Total(wanted);
    for (int c = 0; c < 3; ++c)
    {
      const double mean = sums[lamp][0][c];
      const double error = std::sqrt(std::max(0.0, sums[lamp][1][c] - mean * mean) / Seeds);
      EXPECT_NEAR(mean, double{ wanted.ofLamp[0][c] },
        4.5 * std::hypot(error, std::sqrt(wanted.variance)) + FloatRounding * (mean + 0.01))
        << "lamp " << lamp << ", channel " << c;
    }
  }
  const double spread = square - whole.mean * whole.mean;
  EXPECT_NEAR(whole.mean, exact, 4.5 * std::sqrt(spread / Seeds));
  // Of 2000 estimates; the told variance is a sum of 32 squares, most of them of a few lamps.
  EXPECT_NEAR(whole.toldVariance / spread, 1.0, 0.2);
  EXPECT_NEAR(single, exact, 4.5 * std::sqrt((squareOfSingle - single * single) / Seeds));
}

TEST(DirectLight, LeavesSkiesToTheirRadiance)
{
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.2, 0.1, 1.0));
  Lighting skies;
  skies.luminaires.push_back({ UniformSky{ up, 500.0 }, {}, Colour(1.0f) });
  CieSky clear;
  clear.up = up;
  clear.type = 12;
  clear.sun = { 0.5, -0.4, 0.8 };
  skies.luminaires.push_back({ clear, {}, Colour(1.0f) });
  Surface floor = Shapes::Rectangle({ -4, -4, -1 }, { 8, 0, 0 }, { 0, 8, 0 }, 1);
  floor.metresPerUnit = 3.0;
  const DirectLightRig rig(floor, skies);
  ASSERT_TRUE(rig.light.HasSky());
  EXPECT_EQ(Total(rig.At({ 0, 0, 0 }, { 0, 0, 1 }, 16)), 0.0);
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> directions(500);
  for (glm::dvec3& towards : directions)
  {
    towards = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
  }
  const std::vector<double> luminance = clear.Luminance(directions);
  double squares = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    std::array<double, 2> radiance{};
    const Colour sum = rig.light.SkyRadiance(glm::vec3(directions[i]),
      [&](std::uint32_t lamp, const Colour& light) { radiance[lamp] = double{ light.x }; });
    EXPECT_NEAR(double{ sum.x }, radiance[0] + radiance[1], 1e-6 * double{ sum.x });
    const bool isAbove = glm::dot(directions[i], up) > 0.0;
    EXPECT_NEAR(radiance[0], isAbove ? 500.0 : 0.0, 500.0 * 1e-6);
    const double wanted = isAbove ? luminance[i] : 0.0;
    squares += (radiance[1] - wanted) * (radiance[1] - wanted) / 500.0;
    mean += wanted / 500.0;
  }
  EXPECT_LT(std::sqrt(squares), 1e-3 * mean); // what the table's interpolation leaves, see SkyTable
}

// All walls of a closed room shine evenly, so half of all directions are bright at each place.
// Close to an edge nearly all light comes from the few triangles beside it. A sample that chose
// among all that are near had a standard deviation of 5 times the light there.
TEST(DirectLight, OfOneSampleInTheEdgeOfARoomThatShines)
{
  const Surface room =
    Shapes::WithExitance(Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 12, Facing::Inward), 50.0f);
  const DirectLightRig rig(room, EmittingFacets{});
  for (const double fromWall : { 0.3, 0.03, 0.003, 0.0003 })
  {
    const glm::dvec3 point(0.04, -1.0 + fromWall, -1.0 + 1e-6);
    const MeanOfSeeds one = RepeatSamples(rig, point, { 0, 0, 1 }, 20000);
    EXPECT_NEAR(one.mean, 50.0, 4.5 * one.standardError) << fromWall << " from the wall";
    EXPECT_LT(std::sqrt(one.spread), 2.0 * 50.0) << fromWall << " from the wall";
  }
}
