// SPDX-License-Identifier: BSD-3-Clause
// Light on the curved surface that coarse meshes stand for (CurvedSurface), against the exact one.
#include "Shapes.h"
#include "TracedMap.h"

#include "PhotonTransport/scene/CurvedSurface.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Whether rays meet anything, many at a time.
class Shadows
{
public:
  explicit Shadows(const Surface& surface)
    : Blocker(surface)
  {
  }

  /// @param from, towards In the surface's coordinates.
  bool Blocks(const glm::dvec3& from, const glm::dvec3& towards) const
  {
    const Ray ray{ glm::vec3(this->Blocker.GetPlacement().PointToScene(from)),
      glm::vec3(glm::normalize(towards)) };
    Hit hit;
    this->Blocker.Intersect(&ray, &hit, 1);
    return static_cast<bool>(hit);
  }

private:
  Scene Blocker;
};

/// The share of a grid of points of a plane for which a condition holds, times the grid's area.
double AreaWhere(double halfSide, const std::function<bool(double x, double y)>& holds)
{
  constexpr int Points = 700;
  const double step = 2.0 * halfSide / Points;
  int number = 0;
  for (int i = 0; i < Points; ++i)
  {
    for (int j = 0; j < Points; ++j)
    {
      number += holds((i + 0.5) * step - halfSide, (j + 0.5) * step - halfSide);
    }
  }
  return number * step * step;
}

/// How far the outline of the shadow on a floor 1.2 below the middle of a unit sphere is off the
/// true one on average, in radii. @param lamp Height of the lamp over the middle; infinite:
/// parallel light from above.
double OutlineError(const Surface& surface, double lamp)
{
  constexpr double Floor = -1.2;
  const bool parallel = std::isinf(lamp);
  const double radius =
    parallel ? 1.0 : (lamp - Floor) / std::sqrt(lamp * lamp - 1.0); // of the true shadow
  const Shadows shadows(surface);
  const double wrong = AreaWhere(1.1 * radius,
    [&](double x, double y)
    {
      const glm::dvec3 point(x, y, parallel ? 10.0 : lamp), floor(x, y, Floor);
      const bool dark = parallel ? shadows.Blocks(point, floor - point)
                                 : shadows.Blocks({ 0, 0, lamp }, floor - glm::dvec3(0, 0, lamp));
      return dark != (std::hypot(x, y) < radius);
    });
  return wrong / (2.0 * Pi * radius);
}

/// The area of a beam that a surface catches. @param towards Unit, to the light.
double Caught(const Surface& surface, const glm::dvec3& towards)
{
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.3, 0.5, 0.1), towards));
  const glm::dvec3 ahead = glm::cross(towards, right);
  const Shadows shadows(surface);
  return AreaWhere(1.6,
    [&](double x, double y)
    { return shadows.Blocks(10.0 * towards + x * right + y * ahead, -towards); });
}

struct Body
{
  const char* name;
  Surface surface;
  glm::dvec3 towards;
  double exact;
};

/// The mean of value / exact - 1 over the vertices that have a facet and count.
double MeanError(
  const TracedMap& map, const std::vector<double>& values, double exact,
  const std::function<bool(std::size_t)>& counts = [](std::size_t) { return true; })
{
  double sum = 0.0, number = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    if (map.scene.VertexAreas()[v] > 0.0 && counts(v))
    {
      sum += values[v] / exact - 1.0;
      number += 1.0;
    }
  }
  return sum / number;
}

/// Whether the torus of Shapes::Torus lies between a point of it and the light: sphere tracing.
bool TorusShades(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& towards)
{
  const auto distance = [](const glm::dvec3& p)
  { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - 0.4; };
  double way = 0.0;
  const glm::dvec3 start = point + 1e-6 * normal;
  while (way < 4.0)
  {
    const double step = distance(start + way * towards);
    if (step < 1e-8)
    {
      return true;
    }
    way += step;
  }
  return false;
}

void Print(const char* what, double flat, double curved, const char* unit)
{
  std::printf("  %s: flat %.3g, curved %.3g %s\n", what, flat, curved, unit);
}

} // namespace

TEST(CurvedPatches, ShadowsHaveRoundOutlines)
{
  for (const auto& [name, surface] :
    { std::pair{ "UV sphere 16x8", Shapes::UvSphere(16, 8, Facing::Outward) },
      std::pair{ "icosphere 162", Shapes::Icosphere(2, Facing::Outward) } })
  {
    const Surface curved = CurvedSurface(surface);
    const double parallel = OutlineError(curved, INFINITY), near = OutlineError(curved, 1.6);
    std::printf("  %s, outline in %% of the radius:\n", name);
    Print("parallel light", 100.0 * OutlineError(surface, INFINITY), 100.0 * parallel, "%");
    Print("lamp at 1.6 radii", 100.0 * OutlineError(surface, 1.6), 100.0 * near, "%");
    EXPECT_LT(parallel, 0.0015);
    EXPECT_LT(near, 0.005);
  }
}

// A torus shows a ring to light along its axis, a tube a rectangle to light across it.
TEST(CurvedPatches, CatchTheLightThatTheCurvedSurfaceWould)
{
  const glm::dvec3 slanted = glm::normalize(glm::dvec3(0.3, 0.2, 1.0)), axis(0, 0, 1);
  const glm::dvec3 across(std::cos(Pi / 12.0), std::sin(Pi / 12.0), 0.0);
  const Body bodies[] = { { "UV sphere 16x8", Shapes::UvSphere(16, 8, Facing::Outward), slanted,
                            Pi },
    { "icosphere 162", Shapes::Icosphere(2, Facing::Outward), slanted, Pi },
    { "torus 24x8", Shapes::Torus(24, 8, Facing::Outward), axis, Pi * (1.4 * 1.4 - 0.6 * 0.6) },
    { "tube 12x1", Shapes::Tube(12, 1, Facing::Outward), across, 4.0 } };
  for (const Body& body : bodies)
  {
    const double flat = Caught(body.surface, body.towards) / body.exact - 1.0;
    const double curved = Caught(CurvedSurface(body.surface), body.towards) / body.exact - 1.0;
    Print(body.name, 100.0 * flat, 100.0 * curved, "% of the light");
    EXPECT_LT(std::fabs(curved), 0.003) << body.name;
    EXPECT_LT(std::fabs(curved), 0.2 * std::fabs(flat)) << body.name;
  }
}

// Light that was reflected any number of times: Phi rho / ((1 - rho) 4 pi R^2), where R counts.
TEST(CurvedPatches, AnIntegratingSphereHasTheSphereArea)
{
  const Surface sphere = Shapes::WithReflectance(Shapes::UvSphere(16, 8, Facing::Inward), 0.8f);
  const Lighting lamp{ PointLamp{ { 0, 0, 0 }, 1000.0 } };
  const TracedMap flat(sphere, lamp, {}, 2'000'000);
  const TracedMap curved(CurvedSurface(sphere), lamp, {}, 2'000'000);
  const double exact = 1000.0 * 4.0 / (4.0 * Pi);
  const double before = MeanError(flat, flat.front.indirect, exact);
  const double after = MeanError(curved, curved.front.indirect, exact);
  Print("indirect light", 100.0 * before, 100.0 * after, "% off");
  EXPECT_LT(std::fabs(after), 0.003);
  EXPECT_LT(std::fabs(after), 0.2 * std::fabs(before));
  EXPECT_EQ(curved.balance.escaped, 0u);
}

// The middle ring of a tube that a lamp on its axis lights from inside. The mean over a ring of
// facets on the curved surface (Flat) is right but for their height. Vertex Normalised takes the
// light of each hit as parallel over the whole ring, whose facets at an angle of up to a it would
// meet at a lower cosine: it is too high by 1 / (2 (1 - cos a) / a^2).
TEST(CurvedPatches, ATubeIsLitFromItsAxis)
{
  for (const auto& [around, most] : { std::pair{ 8, 0.015 }, std::pair{ 12, 0.007 } })
  {
    const Surface tube = Shapes::Tube(around, 16, Facing::Inward);
    const Surface curvedTube = CurvedSurface(tube);
    const Lighting lamp{ PointLamp{ { 0, 0, 0 }, 1000.0 } };
    const auto error = [&](const Surface& surface, Registration registration)
    {
      TraceSettings settings;
      settings.registration = registration;
      const TracedMap map(surface, lamp, settings, 4'000'000);
      return MeanError(map, map.front.direct, 1000.0 / (4.0 * Pi),
        [&](std::size_t v) { return std::fabs(tube.points[v].z) < 1e-6; });
    };
    std::printf("  tube of %d sides:\n", around);
    const double flat = error(curvedTube, Registration::Flat);
    const double normalised = error(curvedTube, Registration::VertexNormalised);
    Print("Flat", 100.0 * error(tube, Registration::Flat), 100.0 * flat, "% off");
    Print("Vertex Normalised", 100.0 * error(tube, Registration::VertexNormalised),
      100.0 * normalised, "% off");
    EXPECT_LT(std::fabs(flat), most);
    const double a = 2.0 * Pi / around;
    EXPECT_NEAR(normalised, a * a / (2.0 * (1.0 - std::cos(a))) - 1.0, most);
  }
}

// A sun at 22 degrees, and a torus that shades itself. What is left is the width of the hat
// functions at the border of the shadow.
TEST(CurvedPatches, ATorusShadesItselfAsTheTrueOneDoes)
{
  const Surface torus = Shapes::Torus(24, 8, Facing::Outward);
  const double angle = 22.0 * Pi / 180.0;
  const glm::dvec3 towards(std::cos(angle), 0.0, std::sin(angle));
  std::vector<double> exact;
  for (std::size_t v = 0; v < torus.points.size(); ++v)
  {
    const double cosine = std::max(0.0, glm::dot(torus.normals[v], towards));
    exact.push_back(TorusShades(torus.points[v], torus.normals[v], towards) ? 0.0 : cosine);
  }
  const Lighting sun{ ParallelLight{ -towards, 1.0 } };
  const auto largest = [&](const Surface& surface)
  {
    const TracedMap map(surface, sun, {}, 4'000'000);
    double error = 0.0;
    for (std::size_t v = 0; v < exact.size(); ++v)
    {
      error = std::max(error, std::fabs(map.front.direct[v] - exact[v]));
    }
    return error / *std::max_element(exact.begin(), exact.end());
  };
  const double flat = largest(torus), curved = largest(CurvedSurface(torus));
  Print("largest error", 100.0 * flat, 100.0 * curved, "% of the brightest");
  EXPECT_LT(curved, 0.30);
  EXPECT_LT(curved, flat);
}

TEST(CurvedPatches, ALuminousSurfaceShinesFromItsCurvedArea)
{
  const Surface sphere = Shapes::WithExitance(Shapes::UvSphere(16, 8, Facing::Outward), 100.0f);
  const TracedMap map(CurvedSurface(sphere), Lighting{ EmittingFacets{} }, {}, 100'000);
  EXPECT_NEAR(map.flux, 400.0 * Pi, 0.003 * 400.0 * Pi);
  // Patches meet at slight creases, so a few photons meet the sphere again.
  EXPECT_GT(map.balance.escaped, 0.9998 * static_cast<double>(map.balance.emitted));
}

TEST(CurvedPatches, NoPhotonEscapes)
{
  for (const Surface& surface : { Shapes::UvSphere(16, 8, Facing::Inward),
         Shapes::Torus(24, 8, Facing::Inward), Shapes::Icosphere(0, Facing::Inward) })
  {
    const Surface curved = CurvedSurface(Shapes::WithReflectance(surface, 0.9f));
    const Lighting lamp{ PointLamp{ { 0.62, 0.55, 0.0 }, 1000.0 } };
    const TracedMap map(curved, lamp, {}, 200'000);
    EXPECT_EQ(map.balance.escaped, 0u);
    EXPECT_GT(map.balance.segments, 1'500'000u);
  }
}

TEST(CurvedPatches, FlatSurfacesStayAsTheyAre)
{
  const Surface box = Shapes::Box({ 0, 0, 0 }, { 4, 3, 2 }, 4, Facing::Inward);
  const Surface same = CurvedSurface(box);
  EXPECT_FALSE(same.IsRefined());
  EXPECT_EQ(same.facets, box.facets);
}

// A wall that is drawn once for each side: its outer sheet has all the light that a single one has.
TEST(CurvedPatches, BothSheetsOfAWallAreOneWall)
{
  const Surface out = Shapes::UvSphere(16, 8, Facing::Outward);
  const Surface both = Shapes::Together(out, Shapes::UvSphere(16, 8, Facing::Inward));
  const Lighting sun{ ParallelLight{ { 0.3, 0.2, -1.0 }, 1000.0 } };
  const TracedMap single(CurvedSurface(out), sun, {}, 500'000);
  const TracedMap wall(CurvedSurface(both), sun, {}, 500'000);
  double largest = 0.0;
  for (std::size_t v = 0; v < out.points.size(); ++v)
  {
    EXPECT_NEAR(wall.front.direct[v], single.front.direct[v], 1e-4 * 1000.0);
    largest = std::max(largest, wall.front.direct[out.points.size() + v]);
  }
  EXPECT_EQ(largest, 0.0) << "the inner sheet is dark";
}

TEST(CurvedPatches, HaveTheSameBitsForAnyNumberOfThreads)
{
  const Surface torus =
    CurvedSurface(Shapes::WithReflectance(Shapes::Torus(24, 8, Facing::Outward), 0.5f));
  const Lighting sun{ ParallelLight{ { 0.9, 0.0, -0.4 }, 1000.0 } };
  TraceSettings one, three;
  one.threads = 1;
  three.threads = 3;
  EXPECT_TRUE(
    TracedMap(torus, sun, one, 100'000).HasTheBitsOf(TracedMap(torus, sun, three, 100'000)));
}
