// SPDX-License-Identifier: BSD-3-Clause
// Lamps with a photometric solid: how much, and in which direction.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include "RandomNumbers.h"
#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;
using Type = PhotometricSolid::Type;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;
constexpr int Photons = 100'000;

PhotometricSolid Solid(Type type, double polarStep, double azimuthStep,
  const std::function<double(double, double)>& intensity)
{
  PhotometricSolid solid;
  solid.type = type;
  for (int i = 0; i * polarStep <= 180.0; ++i)
  {
    solid.polar.push_back(i * polarStep);
  }
  for (int i = 0; i * azimuthStep <= 360.0; ++i)
  {
    solid.azimuth.push_back(i * azimuthStep);
    for (const double polar : solid.polar)
    {
      solid.candela.push_back(intensity(polar, solid.azimuth.back()));
    }
  }
  return solid;
}

Scene Ball()
{
  return Scene(Shapes::Icosphere(0, Facing::Outward));
}

void ForDirections(const Emitter& emitter, const std::function<void(const glm::dvec3&)>& f)
{
  PhotonSequence sample({ 1, 0, Sampling::Random }, 0);
  for (int i = 0; i < Photons; ++i, sample.Advance())
  {
    f(glm::dvec3(emitter.Emit(sample).ray.direction));
  }
}

/// Counts below each of ten borders of a quantity must follow its distribution: a binomial each.
void ExpectDistribution(const Emitter& emitter, const std::function<double(const glm::dvec3&)>& of,
  const std::function<double(double)>& distribution, double low, double high, double off = 0.0)
{
  constexpr int Borders = 10;
  int below[Borders] = {};
  ForDirections(emitter,
    [&](const glm::dvec3& direction)
    {
      for (int b = 0; b < Borders; ++b)
      {
        below[b] += of(direction) < low + (high - low) * b / Borders;
      }
    });
  for (int b = 1; b < Borders; ++b)
  {
    const double share = distribution(low + (high - low) * b / Borders);
    EXPECT_NEAR(static_cast<double>(below[b]) / Photons, share,
      4.0 * std::sqrt(share * (1.0 - share) / Photons) + off);
  }
}

} // namespace

TEST(PhotometricLamp, OfEqualIntensitiesIsAPointLamp)
{
  const Scene scene = Ball();
  for (const Type type : { Type::A, Type::B, Type::C })
  {
    const Emitter emitter(PhotometricLamp{ {}, { 1.0, 1.0, -0.3 }, 0.7,
                            Solid(type, 30.0, 90.0, [](double, double) { return 50.0; }), 0.5 },
      scene);
    EXPECT_NEAR(emitter.Flux(), 100.0 * Pi, 1e-12 * 100.0 * Pi);
    for (const glm::dvec3& axis : { glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0, 0.8) })
    {
      ExpectDistribution(
        emitter, [&](const glm::dvec3& d) { return glm::dot(d, axis); },
        [](double cosine) { return 0.5 * (1.0 + cosine); }, -1.0, 1.0);
    }
  }
}

// Between angles one degree apart, cos is at most (pi / 180)^2 / 8 above the straight line.
TEST(PhotometricLamp, OfACosineIsALambertianPointLamp)
{
  const Scene scene = Ball();
  const glm::dvec3 aim = glm::normalize(glm::dvec3(0.2, -1.0, 0.4));
  const Emitter emitter(PhotometricLamp{ {}, aim, 0.0,
                          Solid(Type::C, 1.0, 90.0,
                            [](double p, double) { return std::max(0.0, std::cos(p * Degree)); }),
                          100.0 },
    scene);
  const double most = 2.0 * Pi * Degree * Degree / 8.0; // of the flux of 1 cd, over all the half
  EXPECT_NEAR(emitter.Flux(), 100.0 * Pi, 100.0 * most);
  EXPECT_LT(emitter.Flux(), 100.0 * Pi);
  ExpectDistribution(
    emitter, [&](const glm::dvec3& d) { return std::acos(glm::dot(d, aim)); },
    [](double angle) { return std::pow(std::sin(angle), 2); }, 0.0, 0.5 * Pi, 2.0 * most / Pi);
}

TEST(PhotometricLamp, FluxIsTheSolidsFlux)
{
  RandomNumbers random(1);
  const Scene scene = Ball();
  for (const Type type : { Type::A, Type::B, Type::C })
  {
    const PhotometricSolid solid =
      Solid(type, 22.5, 60.0, [&](double, double) { return double{ random.Unit() }; });
    const Emitter emitter(PhotometricLamp{ {}, { 1, 0, 0 }, 0.0, solid, 3.0 }, scene);
    EXPECT_NEAR(emitter.Flux(), 3.0 * Flux(solid), 1e-12 * emitter.Flux());
  }
}

namespace
{

/// Where PhotometricSolid.h and Lamp.h say that two angles lie: as an unturned lamp has it, turned
/// about the aim, then tilted the shortest way (here as two mirrors, at -z + aim's bisector).
glm::dvec3 Expected(Type type, double polar, double azimuth, const glm::dvec3& aim, double rotation)
{
  const glm::dvec3 d = PhotometricDirection(type, polar, azimuth);
  const glm::dvec3 turned(std::cos(rotation) * d.x - std::sin(rotation) * d.y,
    std::sin(rotation) * d.x + std::cos(rotation) * d.y, d.z);
  const glm::dvec3 down(0.0, 0.0, -1.0);
  if (glm::dot(down, aim) < -1.0 + 1e-9)
  {
    return { turned.x, -turned.y, -turned.z };
  }
  const glm::dvec3 middle = glm::normalize(down + aim);
  const auto mirrored = [](const glm::dvec3& v, const glm::dvec3& plane)
  { return v - 2.0 * glm::dot(v, plane) * plane; };
  // Mirrored at `down` and then at the bisector: a turn by twice the angle between them.
  return mirrored(mirrored(turned, down), middle);
}

} // namespace

TEST(PhotometricLamp, ABeamGoesWhereTheSolidSays)
{
  const Scene scene = Ball();
  const glm::dvec3 aims[] = { { 0, 0, -1 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, -1, 0 },
    { 0.48, 0.6, 0.64 }, { -0.6, 0.48, -0.64 }, { 0.0, 1e-3, 1.0 } };
  for (const Type type : { Type::A, Type::B, Type::C })
  {
    for (const glm::dvec3& given : aims)
    {
      const glm::dvec3 aim = glm::normalize(given);
      for (const double rotation : { 0.0, 0.5, -2.0 })
      {
        for (const auto& [polar, azimuth] : { std::pair(40.0, 60.0), std::pair(120.0, 220.0) })
        {
          const double p0 = polar, z0 = azimuth;
          const Emitter emitter(
            PhotometricLamp{ {}, 5.0 * given, rotation,
              Solid(type, 5.0, 5.0, [&](double p, double z) { return p == p0 && z == z0; }), 1.0 },
            scene);
          const glm::dvec3 expected = Expected(type, polar, azimuth, aim, rotation);
          double least = 1.0;
          glm::dvec3 mean(0.0);
          PhotonSequence sample({ 1, 0, Sampling::Sobol }, 0);
          for (int i = 0; i < 256; ++i, sample.Advance())
          {
            const glm::dvec3 direction(emitter.Emit(sample).ray.direction);
            least = std::min(least, glm::dot(direction, expected));
            mean += direction / 256.0;
          }
          // Bilinear intensities reach five degrees of both angles, and are even to either side.
          EXPECT_GE(least, std::cos(std::hypot(5.0, 5.0) * Degree));
          EXPECT_GE(glm::dot(glm::normalize(mean), expected), std::cos(0.5 * Degree))
            << static_cast<int>(type) << " aim " << aim.x << ' ' << aim.y << ' ' << aim.z
            << " rotation " << rotation << " at " << polar << ' ' << azimuth;
        }
      }
    }
  }
}

TEST(PhotometricLamp, OddSolidsAreTakenAndWrongOnesRefused)
{
  const Scene scene = Ball();
  PhotometricLamp lamp;
  lamp.solid.polar = { 0.0, 90.0 };
  lamp.solid.azimuth = { 90.0, 270.0, 450.0 };
  lamp.solid.candela = { 1, 2, 3, 4, 1, 2 };
  EXPECT_NO_THROW(Emitter(lamp, scene)); // a file of 90 to 270 degrees, mirrored
  const auto refused = [&](const auto& spoil)
  {
    PhotometricLamp spoilt = lamp;
    spoil(spoilt);
    EXPECT_THROW(Emitter(spoilt, scene), InvalidInput);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([&](PhotometricLamp& l) { l.rotation = nan; });
  refused([&](PhotometricLamp& l) { l.scale = -1.0; });
  refused([&](PhotometricLamp& l) { l.solid.polar[1] = nan; });
  refused([&](PhotometricLamp& l) { l.solid.polar[1] = 181.0; });
  refused([&](PhotometricLamp& l) { l.solid.polar[1] = 0.0; });
  refused([&](PhotometricLamp& l) { l.solid.azimuth[2] = 451.0; });
  refused([&](PhotometricLamp& l) { l.solid.azimuth[1] = nan; });
  refused([&](PhotometricLamp& l) { l.solid.candela[2] = nan; });
  refused([&](PhotometricLamp& l) { l.solid.candela[2] = -1e-9; });
  refused([&](PhotometricLamp& l) { l.solid.candela.pop_back(); });
  refused([&](PhotometricLamp& l) { l.solid.candela.assign(6, 0.0); });
  refused([&](PhotometricLamp& l) { l.solid = {}; });
}
