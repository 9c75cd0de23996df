// SPDX-License-Identifier: BSD-3-Clause
// Light at a point by shadow rays, of each kind of lamp, against closed forms.
#include "DirectLightRig.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace PhotonTransport;
using References::ConfigurationFactor;
using Shapes::Facing;

namespace
{

constexpr double Pi = References::Pi;
constexpr double Metres = 2.0; ///< In a unit of the data.

/// Relative; coordinates and cosines are of single precision.
constexpr double FloatRounding = 2e-5;

/// Walls far off that stop nothing.
Surface Walls()
{
  Surface box = Shapes::Box(glm::dvec3(-8.0), glm::dvec3(8.0), 1, Facing::Inward);
  box.metresPerUnit = Metres;
  return box;
}

struct Place
{
  glm::dvec3 point, normal;
};

/// Points around the origin that face any way.
std::vector<Place> RandomPlaces(int count, double far)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
  std::vector<Place> places;
  for (int i = 0; i < count; ++i)
  {
    places.push_back({ far * vector(), glm::normalize(vector()) });
  }
  return places;
}

/// One ray must give the exact light, and no error.
template <class Exact>
void ExpectExactly(const Lamp& lamp, const Exact& exact)
{
  const DirectLightRig rig(Walls(), lamp);
  int lit = 0;
  for (const Place& place : RandomPlaces(200, 3.0))
  {
    const DirectResult result = rig.At(place.point, place.normal, 16);
    const double wanted = exact(place.point, place.normal);
    // A receiver that the light grazes has the rounding of its cosine.
    const double brightest = exact(place.point, glm::dvec3(0.0));
    EXPECT_NEAR(Total(result), wanted, FloatRounding * (wanted + 0.1 * brightest));
    EXPECT_EQ(result.variance, 0.0);
    lit += wanted > 0.0;
  }
  EXPECT_GT(lit, 20);
}

/// Light of an intensity, cd, by the square of the distance; without a normal on what faces it.
template <class Intensity>
auto InverseSquare(const glm::dvec3& position, const Intensity& intensity)
{
  return [=](const glm::dvec3& point, const glm::dvec3& normal)
  {
    const glm::dvec3 way = (point - position) * Metres;
    const double distance = glm::length(way);
    const double cosine =
      normal == glm::dvec3(0.0) ? 1.0 : std::max(0.0, -glm::dot(way, normal) / distance);
    return intensity(way / distance) * cosine / (distance * distance);
  };
}

/// The mean of many estimates, and of many single samples, must be what is exact, within 4.5
/// standard errors. No single sample may be more than `most`.
void ExpectOnAverage(const DirectLightRig& rig, const Place& place, double exact, double most)
{
  const MeanOfSeeds all =
    Repeat([&](std::uint32_t seed) { return rig.At(place.point, place.normal, 16, seed); }, 400);
  const MeanOfSeeds single = RepeatSamples(rig, place.point, place.normal, 4000);
  EXPECT_NEAR(all.mean, exact, 4.5 * all.standardError + FloatRounding * most);
  EXPECT_NEAR(single.mean, exact, 4.5 * single.standardError + FloatRounding * most)
    << "at (" << place.point.x << ", " << place.point.y << ", " << place.point.z << ") facing ("
    << place.normal.x << ", " << place.normal.y << ", " << place.normal.z << ")";
  EXPECT_LE(single.largest, most * (1.0 + FloatRounding));
}

} // namespace

TEST(DirectLight, OfPointLampsIsExact)
{
  const glm::dvec3 position(0.3, -0.2, 0.7);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, 0.1, -1.0));
  ExpectExactly(PointLamp{ position, 900.0 },
    InverseSquare(position, [](const glm::dvec3&) { return 900.0 / (4.0 * Pi); }));
  ExpectExactly(LambertianPointLamp{ position, axis, 900.0 },
    InverseSquare(position,
      [&](const glm::dvec3& d) { return 900.0 / Pi * std::max(0.0, glm::dot(d, axis)); }));
  const double edge = std::cos(1.1);
  ExpectExactly(SpotLamp{ position, axis, 1.1, 3.0, 900.0 },
    InverseSquare(position,
      [&](const glm::dvec3& d)
      {
        const double cosine = glm::dot(d, axis);
        return cosine < edge
          ? 0.0
          : 900.0 * 4.0 / (2.0 * Pi * (1.0 - std::pow(edge, 4.0))) * std::pow(cosine, 3.0);
      }));
  const double wide = std::cos(2.5);
  ExpectExactly(SpotLamp{ position, axis, 2.5, 0.0, 900.0 },
    InverseSquare(position,
      [&](const glm::dvec3& d)
      { return glm::dot(d, axis) < wide ? 0.0 : 900.0 / (2.0 * Pi * (1.0 - wide)); }));
}

TEST(DirectLight, OfAPhotometricLampIsThatOfItsTable)
{
  PhotometricSolid solid;
  for (int p = 0; p <= 150; p += 10)
  {
    solid.polar.push_back(p);
  }
  for (int z = 0; z <= 360; z += 20)
  {
    solid.azimuth.push_back(z);
    for (const double p : solid.polar)
    {
      solid.candela.push_back(100.0 + p + 40.0 * std::sin((p + 2.0 * (z % 360)) * Pi / 180.0));
    }
  }
  const glm::dvec3 position(0.3, -0.2, 0.7);
  for (const auto type :
    { PhotometricSolid::Type::C, PhotometricSolid::Type::B, PhotometricSolid::Type::A })
  {
    solid.type = type;
    PhotometricLamp lamp;
    lamp.position = position;
    lamp.solid = solid;
    lamp.scale = 3.0;
    ExpectExactly(lamp,
      InverseSquare(position,
        [&](const glm::dvec3& d)
        {
          // The angles about the pole, as PhotometricSolid has them for a lamp that aims along -z.
          const glm::dvec3 pole = PhotometricDirection(type, 0.0, 0.0);
          const glm::dvec3 x = PhotometricDirection(type, 90.0, 0.0);
          const glm::dvec3 y = PhotometricDirection(type, 90.0, 90.0);
          const double polar = std::acos(std::clamp(glm::dot(d, pole), -1.0, 1.0)) * 180.0 / Pi;
          const double azimuth = std::atan2(glm::dot(d, y), glm::dot(d, x)) * 180.0 / Pi;
          return 3.0 * Intensity(solid, polar, azimuth);
        }));
  }
}

TEST(DirectLight, OfTheSunIsExact)
{
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, -0.5, 0.9));
  DirectLightRig rig(Shapes::Rectangle({ -1, -1, -3 }, { 2, 0, 0 }, { 0, 2, 0 }, 1),
    ParallelLight{ -towards, 700.0 });
  for (const Place& place : RandomPlaces(50, 0.9))
  {
    const double cosine = glm::dot(towards, place.normal);
    if (std::fabs(cosine) > 0.01)
    {
      const DirectResult result = rig.At(place.point, place.normal, 16);
      EXPECT_NEAR(Total(result), 700.0 * std::max(0.0, cosine), 700.0 * FloatRounding);
      EXPECT_EQ(result.variance, 0.0);
    }
  }
}

// Also 0.1 mm from the panel, beside it and at a slant, where an even density by area has estimates
// of any size.
TEST(DirectLight, OfARectangleIsLamberts)
{
  const RectangleLamp lamp{ { 0, 0, 0 }, { 0, 0, 1 }, 1.2, 0.7, 500.0, { 1, 0, 0 } };
  const std::vector<glm::dvec3> corners{ { -0.6, -0.35, 0 }, { 0.6, -0.35, 0 }, { 0.6, 0.35, 0 },
    { -0.6, 0.35, 0 } };
  const double exitance = 500.0 / (1.2 * 0.7 * Metres * Metres);
  const DirectLightRig rig(Walls(), lamp);
  std::vector<Place> places = RandomPlaces(60, 1.5);
  for (const double height : { 1e-4, 1e-3, 0.03, 0.3, 4.0 })
  {
    places.push_back({ { 0.1, 0.1, height }, { 0, 0, -1 } });
    places.push_back({ { 0.595, 0.1, height }, { 0.5, 0.3, -1 } });
    places.push_back({ { 0.7, -0.4, height }, { -1, 0.2, 0.1 } });
    places.push_back({ { -0.2, 0.34, height }, { 0.1, -1, 0.4 } });
  }
  for (const Place& place : places)
  {
    const glm::dvec3 normal = glm::normalize(place.normal);
    const double exact =
      place.point.z > 0.0 ? exitance * UnitExitance(place.point, normal, corners) : 0.0;
    ExpectOnAverage(rig, { place.point, normal }, exact, 2.0 * exitance);
  }
}

// A disk on a plane parallel to it: 1/2 (1 - (h^2 + a^2 - r^2) / sqrt((h^2 + a^2 + r^2)^2 - 4 a^2
// r^2)) of its exitance (Howell, catalog B-13).
TEST(DirectLight, OfADisk)
{
  const double radius = 0.8;
  const DirectLightRig rig(Walls(), DiskLamp{ { 0, 0, 0 }, { 0, 0, -1 }, radius, 500.0 });
  const double exitance = 500.0 / (Pi * radius * radius * Metres * Metres);
  for (const double h : { 1e-4, 1e-2, 0.2, 1.0, 6.0 })
  {
    for (const double a : { 0.0, 0.3, 0.79, 0.81, 1.1, 5.0 })
    {
      const double sum = h * h + a * a + radius * radius;
      const double share = 0.5 *
        (1.0 -
          (sum - 2.0 * radius * radius) / std::sqrt(sum * sum - 4.0 * a * a * radius * radius));
      const glm::dvec3 place(a * std::cos(1.0), a * std::sin(1.0), -h);
      ExpectOnAverage(rig, { place, { 0, 0, 1 } }, exitance * share, 2.0 * exitance);
    }
  }
  EXPECT_EQ(Total(rig.At({ 0.1, 0.1, 0.2 }, { 0, 0, -1 }, 16)), 0.0);
}

// A ball that stands wholly above the horizon gives what a point in its middle gives.
TEST(DirectLight, OfABall)
{
  const double radius = 0.5;
  const DirectLightRig rig(Walls(), SphereLamp{ { 0, 0, 0 }, radius, 500.0 });
  const double exitance = 500.0 / (4.0 * Pi * radius * radius * Metres * Metres);
  for (const double distance : { 0.5001, 0.6, 1.0, 7.0 })
  {
    const double horizon = std::asin(radius / distance);
    for (const double share : { 0.0, 0.5, 0.99 })
    {
      const double angle = share * (0.5 * Pi - horizon);
      const glm::dvec3 towards = glm::normalize(glm::dvec3(0.2, 0.4, -1.0));
      const glm::dvec3 beside = glm::normalize(glm::cross(towards, glm::dvec3(1, 0, 0)));
      const glm::dvec3 normal = std::cos(angle) * towards + std::sin(angle) * beside;
      const double ratio = radius / distance;
      ExpectOnAverage(rig, { -distance * towards, normal },
        exitance * ratio * ratio * std::cos(angle), 2.0 * exitance);
    }
  }
  EXPECT_EQ(Total(rig.At({ 0.1, 0.1, 0.2 }, { 0, 0, -1 }, 16)), 0.0);
}

// Each element of the tube has the intensity sin(theta) / pi^2 for a lumen.
TEST(DirectLight, OfATube)
{
  const double length = 1.6;
  const DirectLightRig rig(Walls(), LineLamp{ { 0, 0, 0 }, { 0, 1, 0 }, length, 500.0 });
  std::vector<Place> places = RandomPlaces(40, 1.5);
  places.push_back({ { 1e-3, 0.3, 0 }, { -1, 0, 0 } });
  places.push_back({ { 0.01, 0.81, 0 }, { -1, -2, 0 } });
  places.push_back({ { 0, 6, 0.5 }, { 0, -1, 0 } });
  for (const Place& place : places)
  {
    const glm::dvec3 normal = glm::normalize(place.normal);
    const double d = std::hypot(place.point.x, place.point.z);
    // Over the angle from the foot on the axis, where the integrand is smooth.
    const auto at = [&](double angle)
    {
      const glm::dvec3 way = glm::dvec3(0, place.point.y + d * std::tan(angle), 0) - place.point;
      return std::max(0.0, glm::dot(glm::normalize(way), normal)) * std::cos(angle) / d;
    };
    const double from = std::atan((-0.5 * length - place.point.y) / d);
    const double to = std::atan((0.5 * length - place.point.y) / d);
    double exact = 0.0;
    constexpr int Parts = 200;
    for (int i = 0; i < Parts; ++i)
    {
      exact += References::Integral(
        at, from + (to - from) * i / Parts, from + (to - from) * (i + 1) / Parts);
    }
    const double unit = 500.0 / (Pi * Pi * length * Metres * Metres);
    ExpectOnAverage(rig, { place.point, normal }, unit * exact, 2.0 * unit / d);
  }
}
