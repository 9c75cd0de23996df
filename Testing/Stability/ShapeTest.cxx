// SPDX-License-Identifier: BSD-3-Clause
// Cases 2 and 3: normals and triangles that no one would draw, but files have.
#include "CoreTools.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

const Lamp Sun = ParallelLight{ { 0.3, 0.2, -1.0 }, 1000.0 };
constexpr std::uint64_t Photons = 20'000;

Shapes::Surface Sphere()
{
  return Shapes::WithReflectance(Shapes::Octasphere(3, Facing::Outward), 0.5f);
}

using Case2 = EveryWay;
using Case3 = EveryWay;

} // namespace

INSTANTIATE_TEST_SUITE_P(Stability, Case2, AllWays(), NameOfWay);
INSTANTIATE_TEST_SUITE_P(Stability, Case3, AllWays(), NameOfWay);

TEST_P(Case2, LengthOfNormalsDoesNotMatter)
{
  Shapes::Surface surface = Sphere();
  const TracedMap unit(surface, Sun, GetParam().Settings(), Photons);
  for (std::size_t v = 0; v < surface.normals.size(); ++v)
  {
    surface.normals[v] *= std::ldexp(1.0, static_cast<int>(v % 133) - 66); // 1e-20 to 1e20
  }
  const TracedMap scaled(surface, Sun, GetParam().Settings(), Photons);
  EXPECT_EQ(scaled.front.direct, unit.front.direct);
  EXPECT_EQ(scaled.front.indirect, unit.front.indirect);
  Report("normals that are not unit vectors", "lengths of 1e-20 to 1e20: the same bits");
}

TEST_P(Case2, NormalsThatSayNothingAreReplaced)
{
  Shapes::Surface surface = Sphere();
  constexpr double Bad[] = { 0.0, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  std::size_t replaced = 0;
  for (std::size_t v = 0; v < surface.normals.size(); v += 5, ++replaced)
  {
    surface.normals[v] = glm::dvec3(Bad[replaced % 3]);
  }
  const TracedMap run(surface, Sun, GetParam().Settings(), Photons);
  EXPECT_EQ(run.scene.Notes().replacedNormals, replaced);
  Report("zero, NaN and infinite normals", std::to_string(replaced) + " replaced and noted");
}

TEST_P(Case2, NormalsAwayFromTheirFacets)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double largest = 0.0;
  for (const char* kind : { "random", "inwards", "alternating", "sideways" })
  {
    SCOPED_TRACE(kind);
    Shapes::Surface surface = Sphere();
    for (std::size_t v = 0; v < surface.normals.size(); ++v)
    {
      glm::dvec3& n = surface.normals[v];
      switch (kind[0])
      {
        case 'r':
          n = { normal(random), normal(random), normal(random) };
          break;
        case 'i':
          n = -n;
          break;
        case 'a':
          n = v % 2 == 0 ? n : -n;
          break;
        default:
          n = glm::cross(n, glm::dvec3(0.3, 0.9, 0.1));
      }
    }
    const TracedMap run(surface, Sun, GetParam().Settings(), Photons);
    largest = std::max(largest, run.fluxCut / run.flux);
  }
  char text[80];
  std::snprintf(text, sizeof(text), "sound maps; cut off at most %.2g of the flux", largest);
  Report("normals like noise, inside out or in the surface", text);
}

TEST_P(Case2, VerticesWithoutFacetsAreDark)
{
  Shapes::Surface surface = Sphere();
  surface.points.push_back({ 5.0, 5.0, 5.0 });
  surface.normals.push_back({ 0.0, 0.0, 1.0 });
  const TracedMap run(surface, Sun, GetParam().Settings(), Photons);
  EXPECT_EQ(run.front.direct.back(), 0.0);
  EXPECT_EQ(run.front.standardError.back(), 0.0);
  Report("division by an area of 0", "a vertex without a facet has 0 lx");
}

TEST_P(Case2, ANeedleFanAndASharedCorner)
{
  // A cone of 1000 needles, welded to a cube's corner.
  Shapes::Surface surface;
  surface.points.push_back({ 0.0, 0.0, 1.0 });
  surface.normals.push_back({ 0.0, 0.0, 1.0 });
  constexpr unsigned Around = 1000;
  for (unsigned i = 0; i < Around; ++i)
  {
    const double angle = 6.283185307179586 * i / Around;
    surface.points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    surface.normals.push_back({ std::cos(angle), std::sin(angle), 1.0 });
    surface.facets.emplace_back(0, 1 + i, 1 + (i + 1) % Around);
  }
  surface.points.push_back({ 0.0, 0.0, 3.0 });
  surface.normals.push_back({ 1.0, 1.0, 1.0 });
  surface.facets.emplace_back(0, 1, Around + 1);
  surface.facets.emplace_back(0, Around + 1, 300);
  surface = Shapes::WithReflectance(surface, 0.5f);
  const TracedMap run(surface, Sun, GetParam().Settings(), Photons);
  Report("a vertex of 1000 needles that a sharp edge shares", "a sound map");
}

TEST_P(Case3, TrianglesOfEveryKindOfBadness)
{
  // A closed room, so that all light arrives somewhere, with everything in it that files bring.
  Shapes::Surface surface = Shapes::Box({ -2, -2, -2 }, { 2, 2, 2 }, 5, Facing::Inward);
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const auto first = static_cast<unsigned>(surface.points.size());
    for (const glm::dvec3& point : { a, b, c })
    {
      surface.points.push_back(point);
      surface.normals.push_back({ 0.0, 0.0, 1.0 });
    }
    surface.facets.emplace_back(first, first + 1, first + 2);
  };
  add({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, 0 });         // no area
  add({ 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 });           // a point
  add({ -1, 0, 0.5 }, { 1, 0, 0.5 }, { 0, 2e-6, 0.5 }); // aspect 1e6
  add({ -1, -1, -1 }, { 1, -1, -1 }, { 0, 1, -1 });
  add({ -1, -1, -1 }, { 1, -1, -1 }, { 0, 1, -1 });    // the same again
  add({ 1, -1, -1 }, { -1, -1, -1 }, { 0, 1, -1 });    // and from the other side
  add({ 0, -1, -1.5 }, { 0, 1, -1.5 }, { 0, 0, 1.5 }); // through all of them
  surface.facets.emplace_back(3, 3, 4);                // an index twice
  surface.facets.emplace_back(0, 1, 2);                // a third facet on edges of the room
  surface = Shapes::WithReflectance(surface, 0.7f);
  const TracedMap run(
    surface, PointLamp{ { 0.3, 0.3, 1.0 }, 1000.0 }, GetParam().Settings(), 50'000);
  EXPECT_EQ(run.balance.escaped, 0u);
  EXPECT_GE(run.scene.Notes().droppedFacets, 3u);
  Report("zero area, needles, duplicates, opposite sheets, T-junctions, self-intersections",
    "all light arrives; " + std::to_string(run.scene.Notes().droppedFacets) +
      " facets dropped and noted");
}

TEST_P(Case3, AGiantBesideDust)
{
  // 100 thousand facets of a ten-thousandth next to one of a hundred.
  Shapes::Surface surface = Shapes::Rectangle(
    { -0.005, -0.005, 0.001 }, { 0.01, 0.0, 0.0 }, { 0.0, 0.01, 0.0 }, LongTests() ? 707 : 224);
  surface = Shapes::Together(
    surface, Shapes::Rectangle({ -50.0, -50.0, 0.0 }, { 100.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 }, 1));
  surface = Shapes::WithReflectance(surface, 0.5f);
  const SpotLamp lamp{ { 0.0, 0.0, 0.1 }, { 0.0, 0.0, -1.0 }, 0.04, 0.0, 1000.0 };
  const TracedMap run(surface, lamp, GetParam().Settings(), 200'000);
  double dust = 0.0;
  for (std::size_t v = 0; v + 4 < run.front.direct.size(); ++v)
  {
    dust += run.scene.VertexAreas()[v] * run.front.direct[v];
  }
  // The spot's cone, 0.04 rad at 0.099 m, lies within the dust: all of its light lands there.
  EXPECT_NEAR(dust / 1000.0, 1.0, 1e-3);
  char text[80];
  std::snprintf(
    text, sizeof(text), "%.5f of the light lands on the dust it is meant for", dust / 1000.0);
  Report("precision lost where sizes differ by 10^6", text);
}
