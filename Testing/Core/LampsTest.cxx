// SPDX-License-Identifier: BSD-3-Clause
// Spheres, tubes, meshes and skies against closed forms.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "Shapes.h"
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr std::uint64_t Photons = 400'000;

TraceSettings RandomSettings()
{
  TraceSettings settings;
  settings.sampling = Sampling::Random;
  return settings;
}

/// The share of a lamp's light that lands on a black surface's fronts must be what is expected: a
/// binomial, four deviations.
void ExpectShare(
  const Surface& surface, const Lamp& lamp, double expected, double geometryError = 0.0)
{
  const Scene scene(surface);
  const TracedMap map(scene, lamp, RandomSettings(), Photons);
  std::uint64_t hits = 0;
  for (const std::uint64_t count : map.front.photonHits)
  {
    hits += count;
  }
  const auto emitted = static_cast<double>(map.balance.emitted);
  const double deviation = std::sqrt(expected * (1.0 - expected) / emitted);
  EXPECT_NEAR(static_cast<double>(hits) / 3.0 / emitted, expected, 4.0 * deviation + geometryError);
}

/// Of E over the rectangle [x0, x1] x [y0, y1], by the midpoint rule with `cells`^2 points.
double Midpoints(const std::function<double(double, double)>& e, double x0, double x1, double y0,
  double y1, int cells)
{
  double sum = 0.0;
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      sum += e(x0 + (x1 - x0) * (i + 0.5) / cells, y0 + (y1 - y0) * (j + 0.5) / cells);
    }
  }
  return sum * (x1 - x0) * (y1 - y0) / (cells * cells);
}

} // namespace

// E = Phi / (4 pi d^2) on whatever sees all of the sphere, as from a point: the flux through a
// coaxial disk is (1 - cos) / 2, and that onto a rectangle the same as a point lamp's.
TEST(SphereLamp, LightsAsAPointDoesFromOutside)
{
  for (const double radius : { 0.0, 0.01, 0.5, 0.99 })
  {
    for (const double distance : { 1.0, 2.0, 5.0 })
    {
      const double share = 0.5 * (1.0 - distance / std::hypot(distance, 1.0));
      // A disk of 720 corners lacks 1 - sin(a) / a = 1.3e-5 of its area.
      ExpectShare(Shapes::Disk(1.0, 0.0, 720, 1, true),
        SphereLamp{ { 0.0, 0.0, distance }, radius, 10.0 }, share, 2e-5 * share);
    }
    const auto e = [](double x, double y) // of a lamp of 1 lm at height 1
    { return 1.0 / (4.0 * Pi * std::pow(x * x + y * y + 1.0, 1.5)); };
    const double coarse = Midpoints(e, 0.5, 2.5, -0.5, 1.0, 100);
    const double fine = Midpoints(e, 0.5, 2.5, -0.5, 1.0, 200);
    ExpectShare(Shapes::Rectangle({ 0.5, -0.5, 0 }, { 2.0, 0, 0 }, { 0, 1.5, 0 }, 2),
      SphereLamp{ { 0.0, 0.0, 1.0 }, radius, 7.0 }, fine, std::fabs(fine - coarse));
  }
}

// I = Phi / pi^2 sin: the share within an angle t of the axis is (t - sin t cos t) / pi.
TEST(LineLamp, IntensityIsTheSineOfTheAngleToItsAxis)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
  const Emitter emitter(LineLamp{ glm::dvec3(0.2), 3.0 * axis, 0.8, 5.0 }, scene);
  EXPECT_EQ(emitter.Flux(), 5.0);
  const glm::dvec3 centre = scene.GetPlacement().PointToScene(glm::dvec3(0.2));
  const double half = scene.GetPlacement().LengthToScene(0.4);
  constexpr int Photon = 200'000;
  constexpr int Angles = 10;
  int within[Angles] = {}, along[Angles] = {};
  PhotonSequence sample({ 1, 0, Sampling::Random }, 0);
  for (int i = 0; i < Photon; ++i, sample.Advance())
  {
    const Ray ray = emitter.Emit(sample).ray;
    const glm::dvec3 from = glm::dvec3(ray.origin) - centre;
    const double place = glm::dot(from, axis) / half;
    EXPECT_LE(glm::length(from - place * half * axis), 4.0 * 0x1p-24); // on the axis
    ASSERT_LE(std::fabs(place), 1.0 + 8.0 * 0x1p-24 / half);
    const double angle =
      std::acos(std::clamp(glm::dot(glm::dvec3(ray.direction), axis), -1.0, 1.0));
    for (int a = 0; a < Angles; ++a)
    {
      within[a] += angle < Pi * a / Angles;
      along[a] += place < 2.0 * a / Angles - 1.0;
    }
  }
  for (int a = 1; a < Angles; ++a)
  {
    const double t = Pi * a / Angles;
    const double share = (t - std::sin(t) * std::cos(t)) / Pi;
    EXPECT_NEAR(within[a], Photon * share, 4.0 * std::sqrt(Photon * share * (1.0 - share)));
    const double part = double{ 1.0 } * a / Angles;
    EXPECT_NEAR(along[a], Photon * part, 4.0 * std::sqrt(Photon * part * (1.0 - part)));
  }
}

// E at height h below a line of intensity I_0 sin, at distance d from it:
// I_0 h d / L integral of dx / r^4 = I_0 h / (2 L d) [x / r^2 + atan(x / d) / d].
TEST(LineLamp, LightsAPlaneByItsConfigurationFactor)
{
  const double length = 1.2, height = 0.5;
  const auto e = [&](double x, double y)
  {
    const double d = std::hypot(y, height);
    const auto primitive = [&](double s) { return s / (s * s + d * d) + std::atan(s / d) / d; };
    return height / (2.0 * length * d) *
      (primitive(0.5 * length - x) - primitive(-0.5 * length - x)) / (Pi * Pi);
  };
  const double coarse = Midpoints(e, -0.3, 1.7, -0.4, 0.8, 100);
  const double fine = Midpoints(e, -0.3, 1.7, -0.4, 0.8, 200);
  ExpectShare(Shapes::Rectangle({ -0.3, -0.4, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 1.2, 0.0 }, 2),
    LineLamp{ { 0.0, 0.0, height }, { -1.0, 0.0, 0.0 }, length, 3.0 }, fine,
    std::fabs(fine - coarse));
}

// View factor of two unit squares, parallel, one apart (Howell, catalog C-11).
TEST(EmittingMesh, ShinesAsFacetsDo)
{
  const double share = 2.0 / Pi *
    (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
      2.0 * std::atan(1.0));
  const Surface receiver = Shapes::Rectangle({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4);
  const Surface panel = Shapes::Rectangle({ -0.5, -0.5, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, 3);
  EmittingMesh mesh{ panel.points, panel.facets, {} };
  mesh.exitance.assign(panel.facets.size(), 100.0f);
  ExpectShare(receiver, mesh, share);
  for (glm::uvec3& facet : mesh.facets)
  {
    std::swap(facet.y, facet.z); // shines upwards
  }
  ExpectShare(receiver, mesh, 0.0);
}

TEST(EmittingMesh, HasTheFluxOfTheSameFacets)
{
  Surface ball = Shapes::Icosphere(1, Facing::Outward);
  ball.metresPerUnit = 0.1;
  std::vector<float> exitance;
  for (std::size_t f = 0; f < ball.facets.size(); ++f)
  {
    exitance.push_back(f % 3 == 0 ? 0.0f : static_cast<float>(f));
    ball.exitance.emplace_back(exitance.back());
  }
  const Scene scene(ball);
  const Emitter facets(EmittingFacets{}, scene);
  const Emitter mesh(EmittingMesh{ ball.points, ball.facets, exitance }, scene);
  // Coordinates in single precision move an area by 8 roundings at most.
  EXPECT_NEAR(mesh.Flux(), facets.Flux(), 8.0 * 0x1p-24 * facets.Flux());
  // The same numbers choose the same place on the same facet, but for what keeps facets' rays from
  // the edges; and the same direction, but for rounding.
  PhotonSequence sample({ 1, 0, Sampling::Sobol }, 0);
  int differ = 0;
  for (int i = 0; i < 10'000; ++i, sample.Advance())
  {
    const Ray a = facets.Emit(sample).ray;
    const Ray b = mesh.Emit(sample).ray;
    differ +=
      glm::length(a.origin - b.origin) > 1e-4f || glm::length(a.direction - b.direction) > 1e-4f;
  }
  EXPECT_LE(differ, 2); // at a border between two facets' shares
}

// A copy may start at any corner, and have points of its own. A back is no copy of its front.
TEST(EmittingMesh, ExactCopiesShineOnce)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  const std::vector<glm::dvec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -0.0, 1, 0 } };
  const EmittingMesh one{ points, { { 0, 1, 2 } }, { 5.0f } };
  const double flux = Emitter(one, scene).Flux();
  EXPECT_TRUE(one.Notes("a").empty());
  for (const glm::uvec3 copy : { glm::uvec3{ 0, 1, 2 }, { 1, 2, 0 }, { 3, 0, 1 } })
  {
    const EmittingMesh mesh{ points, { { 0, 1, 2 }, copy, copy }, { 5.0f, 3.0f, 5.0f } };
    EXPECT_EQ(Emitter(mesh, scene).Flux(), flux);
    EXPECT_EQ(mesh.Notes("a").at(0).find("2 triangles of luminaire 'a' are exact copies"), 0u);
  }
  const EmittingMesh dim{ points, { { 0, 1, 2 }, { 1, 2, 0 } }, { 0.0f, 5.0f } };
  EXPECT_EQ(Emitter(dim, scene).Flux(), flux); // of copies the brightest shines
  const EmittingMesh bothSides{ points, { { 0, 1, 2 }, { 0, 2, 1 } }, { 5.0f, 5.0f } };
  EXPECT_EQ(Emitter(bothSides, scene).Flux(), 2.0 * flux);
  EXPECT_TRUE(bothSides.Notes("a").empty());
}

TEST(EmittingMesh, ContradictionsAreRefused)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  EmittingMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }, { 1.0f } };
  EXPECT_NO_THROW(Emitter(mesh, scene));
  const auto refused = [&](const auto& spoil)
  {
    EmittingMesh spoilt = mesh;
    spoil(spoilt);
    EXPECT_THROW(Emitter(spoilt, scene), std::runtime_error);
  };
  refused([](EmittingMesh& m) { m.exitance.clear(); });
  refused([](EmittingMesh& m) { m.exitance[0] = -1.0f; });
  refused([](EmittingMesh& m) { m.exitance[0] = std::nanf(""); });
  refused([](EmittingMesh& m) { m.exitance[0] = 0.0f; });
  refused([](EmittingMesh& m) { m.facets[0].y = 3; });
  refused([](EmittingMesh& m) { m.facets[0].y = 0; });
  refused([](EmittingMesh& m) { m.points[2].x = std::nan(""); });
}

TEST(CieSky, UniformTypeIsTheUniformSky)
{
  const Scene scene(Shapes::Icosphere(1, Facing::Outward));
  const glm::dvec3 up(0.3, -0.2, 1.0);
  const Emitter cie(CieSky{ up, 5, { 1.0, 0.0, 1.0 }, 12'000.0 }, scene);
  const Emitter uniform(UniformSky{ up, 12'000.0 / Pi, false }, scene);
  EXPECT_NEAR(cie.Flux(), uniform.Flux(), 1e-12 * uniform.Flux()); // some hundred double roundings
}

// What the sky is said to give to a horizontal plane is what it gives.
TEST(CieSky, LightsAHorizontalPlaneAsSaid)
{
  const glm::dvec3 up = glm::normalize(glm::dvec3(1.0, 2.0, 2.0));
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(1.0, 0.0, 0.0), up));
  const Surface plane = Shapes::Rectangle({ 0, 0, 0 }, u, glm::cross(up, u), 1);
  for (const int type : { 1, 5, 12, 15, 16 })
  {
    for (const glm::dvec3& sun : { up, up + 2.0 * u, up - 0.4 * glm::cross(up, u) })
    {
      const CieSky sky{ up, type, sun, 5000.0 };
      ExpectShare(plane, sky, 5000.0 / Emitter(sky, Scene(plane)).Flux(), 1e-6);
    }
  }
}
