// SPDX-License-Identifier: BSD-3-Clause
// Cases of CIE 171:2006 with lamps, and their like, against closed forms.
#include "Comparison.h"
#include "References.h"
#include "Shapes.h"
#include "TracedMap.h"
#include "ValidationCase.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace PhotonTransport;
using References::Pi;
using Shapes::Facing;

namespace
{

const glm::dvec3 Down(0.0, 0.0, -1.0);

/// The whole floor [-2, 2]^2 has index 0 on; vertices of an 8 x 8 grid, row by row.
constexpr int FloorCells = 8;
constexpr std::size_t At(std::size_t column, std::size_t row)
{
  return row * (FloorCells + 1) + column;
}
constexpr std::size_t Middle = At(4, 4), Side = At(8, 4), Corner = At(0, 0);

Surface Floor()
{
  return Shapes::Rectangle({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, FloorCells);
}

/// What the map says at single points, against the mean of E over the facets around them.
std::vector<Quantity> Points(
  const Surface& surface, const Illuminance& exact, const std::vector<std::size_t>& points)
{
  const std::vector<double> means = RingMeans(surface, exact);
  std::vector<Quantity> quantities;
  for (const std::size_t point : points)
  {
    quantities.push_back({ means[point], PointWeights(surface, point) });
  }
  return quantities;
}

std::vector<double> Everywhere(const Surface& surface, double scale = 1.0)
{
  return IntegralWeights(surface, std::vector<bool>(surface.points.size(), true),
    std::vector<double>(surface.points.size(), scale));
}

} // namespace

// E = I cos(angle at the floor) / d^2, I = flux / (4 pi).
TEST(Cie171, PointLamp)
{
  const glm::dvec3 lamp(0.0, 0.0, 3.0);
  const double intensity = 1000.0 / (4.0 * Pi);
  const auto exact = [&](const glm::dvec3& p, const glm::dvec3&)
  {
    const double d = glm::length(lamp - p);
    return intensity * lamp.z / (d * d * d);
  };
  ExpectExact({ "5.2 point lamp, even intensity", Floor(), PointLamp{ lamp, 1000.0 },
    Points(Floor(), exact, { Middle, Side, Corner }), 20e6 });
}

// I = I0 cos: E = I0 h^2 / d^4.
TEST(Cie171, LambertianPointLamp)
{
  const double h = 3.0;
  const double intensity = 1000.0 / Pi;
  const auto exact = [&](const glm::dvec3& p, const glm::dvec3&)
  {
    const double d2 = p.x * p.x + p.y * p.y + h * h;
    return intensity * h * h / (d2 * d2);
  };
  ExpectExact(
    { "5.2 point lamp, I0 h^2 / d^4", Floor(), LambertianPointLamp{ { 0.0, 0.0, h }, Down, 1000.0 },
      Points(Floor(), exact, { Middle, Side, Corner }), 20e6 });
}

TEST(Cie171, AreaLamp)
{
  // A horizontal panel over the floor and beside a wall, whose foot is an edge of the floor.
  const RectangleLamp lamp{ { 0.5, -0.25, 2.0 }, Down, 1.0, 0.5, 1000.0 };
  const std::vector<glm::dvec3> corners{ { 0.0, -0.5, 2.0 }, { 1.0, -0.5, 2.0 }, { 1.0, 0.0, 2.0 },
    { 0.0, 0.0, 2.0 } };
  const auto exact = [&](const glm::dvec3& p, const glm::dvec3& normal)
  { return 1000.0 / 0.5 * References::ConfigurationFactor(p, normal, corners); };
  ExpectExact({ "5.3 area lamp, parallel receiver", Floor(), lamp,
    Points(Floor(), exact, { Middle, Side, Corner }), 20e6 });
  const Surface wall =
    Shapes::Rectangle({ -2, 2, 0 }, { 4, 0, 0 }, { 0, 0, 1.5 }, FloorCells); // below the lamp
  ExpectExact({ "5.3 area lamp, perpendicular receiver", wall, lamp,
    Points(wall, exact, { Middle, Side, Corner }), 20e6 });
}

TEST(Cie171, FluxIsConserved)
{
  const Surface box = Shapes::Box({ -2, -2, 0 }, { 2, 2, 3 }, 8, Facing::Inward);
  ExpectExact({ "5.4 flux on all walls of a closed box", box,
    SpotLamp{ { 0.5, 0.3, 2.5 }, { 0.2, 0.1, -1.0 }, 0.9, 2.0, 1000.0 },
    { { 1000.0, Everywhere(box) } }, 1e6 });
  // The rest of a box without its roof gets what does not leave by the roof's solid angle.
  const Surface room = Shapes::OpenRoom(4.0, 3.0, { -2, -2, 2, 2 }, 4);
  const double share = References::RectangleSolidAngle(2.0, 2.0, 2.0) / (4.0 * Pi);
  ExpectExact(
    { "5.4 flux that an open roof leaves in a room", room, PointLamp{ { 0.0, 0.0, 1.0 }, 1000.0 },
      { { 1000.0 * (1.0 - share), Everywhere(room) } }, 4e6 });
}

class Interreflection : public testing::TestWithParam<double>
{
};
INSTANTIATE_TEST_SUITE_P(Cie171, Interreflection,
  testing::Values(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95),
  [](const auto& instance)
  { return "Reflectance" + std::to_string(static_cast<int>(100.0 * instance.param + 0.5)); });

// Mean indirect E = rho flux / (S (1 - rho)).
TEST_P(Interreflection, InACube)
{
  const double rho = GetParam();
  const Surface cube = Shapes::WithReflectance(
    Shapes::Box({ -2, -2, -2 }, { 2, 2, 2 }, 4, Facing::Inward), static_cast<float>(rho));
  const double area = 96.0;
  char name[64];
  std::snprintf(name, sizeof(name), "5.8 interreflection in a cube, reflectance %.2f", rho);
  ExpectExact({ name, cube, PointLamp{ { 0.0, 0.0, 0.0 }, 1000.0 },
    { { rho * 1000.0 / (area * (1.0 - rho)), Everywhere(cube, 1.0 / area), true } }, 4e6 });
}

TEST(Cie171, BlackWallsReflectNothing)
{
  const Scene cube(Shapes::Box({ -2, -2, -2 }, { 2, 2, 2 }, 4, Facing::Inward));
  const TracedMap map(cube, PointLamp{ { 0.0, 0.0, 0.0 }, 1000.0 }, {}, 100'000);
  for (const double indirect : map.front.indirect)
  {
    EXPECT_EQ(indirect, 0.0);
  }
}

// In a sphere the indirect light is the same everywhere, wherever the lamp is.
TEST(Cie171, IntegratingSphere)
{
  const Surface sphere = Shapes::WithReflectance(Shapes::Icosphere(6, Facing::Inward), 0.8f);
  const glm::dvec3 lamp(0.0, 0.0, 0.6);
  const double indirect = 0.8 * 1000.0 / (4.0 * Pi * 0.2);
  // Means over the zones nearest to the lamp, about the equator, farthest from it.
  std::vector<Quantity> quantities;
  for (const double z : { 0.75, 0.0, -0.75 })
  {
    std::vector<bool> counts;
    std::vector<double> exact;
    for (const glm::dvec3& p : sphere.points)
    {
      counts.push_back(std::fabs(p.z - z) < 0.25);
      const glm::dvec3 ray = p - lamp;
      const double d = glm::length(ray);
      exact.push_back(indirect + 1000.0 / (4.0 * Pi) * glm::dot(ray, p) / (d * d * d));
    }
    Quantity zone{ 0.0,
      IntegralWeights(sphere, counts, std::vector<double>(sphere.points.size(), 1.0)) };
    zone.exact = std::inner_product(exact.begin(), exact.end(), zone.weights.begin(), 0.0);
    quantities.push_back(std::move(zone));
  }
  ExpectExact({ "integrating sphere, eccentric lamp", sphere, PointLamp{ lamp, 1000.0 },
    std::move(quantities), 1e6 });
}

// E = pi L (1 + cos(tilt)) / 2 on a sphere below a uniform half sky.
TEST(Cie171, UniformSkyOnASphere)
{
  const Surface sphere = Shapes::Icosphere(5, Facing::Outward);
  std::vector<Quantity> quantities;
  for (const double z : { 0.75, 0.0, -0.5 })
  {
    std::vector<bool> counts;
    std::vector<double> exact;
    for (const glm::dvec3& p : sphere.points)
    {
      counts.push_back(std::fabs(p.z - z) < 0.25);
      exact.push_back(Pi * 1000.0 * (1.0 + p.z) / 2.0);
    }
    Quantity zone{ 0.0,
      IntegralWeights(sphere, counts, std::vector<double>(sphere.points.size(), 1.0)) };
    zone.exact = std::inner_product(exact.begin(), exact.end(), zone.weights.begin(), 0.0);
    quantities.push_back(std::move(zone));
  }
  ExpectExact({ "uniform sky on a sphere", sphere, UniformSky{ { 0, 0, 1 }, 1000.0, false },
    std::move(quantities), 4e6 });
}

// Of a panel's light on a receiver: Howell's catalog C-11, C-14 and C-41.
TEST(Cie171, ViewFactors)
{
  const auto expect = [](const char* name, const Surface& receiver, const Lamp& lamp, double factor)
  {
    ExpectExact({ name, receiver, lamp, { { 1000.0 * factor, Everywhere(receiver) } }, 4e6 });
  };
  const double root2 = std::sqrt(2.0);
  const RectangleLamp above{ { 0, 0, 1 }, Down, 1.0, 1.0, 1000.0 };
  expect("view factor of parallel squares",
    Shapes::Rectangle({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4), above,
    2.0 / Pi *
      (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * root2 * std::atan(1.0 / root2) -
        2.0 * std::atan(1.0)));
  const RectangleLamp beside{ { 0, 0.5, 0.5 }, { 1, 0, 0 }, 1.0, 1.0, 1000.0 };
  expect("view factor of perpendicular squares",
    Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4), beside,
    1.0 / Pi * (2.0 * std::atan(1.0) - root2 * std::atan(1.0 / root2) + 0.25 * std::log(0.75)));
  // A disk of 1440 corners misses 3e-6 of its area.
  expect("view factor of coaxial disks", Shapes::Disk(1.0, 0.0, 1440, 1, true),
    DiskLamp{ { 0, 0, 1 }, Down, 1.0, 1000.0 }, 0.5 * (3.0 - std::sqrt(5.0)));
}
