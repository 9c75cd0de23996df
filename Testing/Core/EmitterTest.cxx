// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;

void ForPhotons(const Emitter& emitter, int count, const std::function<void(const Ray&)>& f)
{
  PhotonSequence sample({ 1, 0, Sampling::Sobol }, 0);
  for (int i = 0; i < count; ++i, sample.Advance())
  {
    f(emitter.Emit(sample).ray);
  }
}

void ExpectRefused(const Lamp& lamp, const std::string& words)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  try
  {
    const Emitter emitter(lamp, scene);
    FAIL() << "accepted; expected: " << words;
  }
  catch (const InvalidInput& error)
  {
    EXPECT_EQ(error.Kind, InvalidInput::Where::LampSettings);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(Emitter, RefusesLampsThatMakeNoSense)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused(ParallelLight{ glm::dvec3(0.0), 1.0 }, "lamp direction (0, 0, 0)");
  ExpectRefused(ParallelLight{ glm::dvec3(nan), 1.0 }, "lamp direction");
  ExpectRefused(ParallelLight{ glm::dvec3(1.0), -1.0 }, "illuminance -1");
  ExpectRefused(PointLamp{ glm::dvec3(nan), 1.0 }, "lamp position");
  ExpectRefused(PointLamp{ glm::dvec3(0.0), nan }, "luminous flux");
  ExpectRefused(SpotLamp{ glm::dvec3(0.0), glm::dvec3(1.0), 0.0, 0.0, 1.0 }, "half-angle 0");
  ExpectRefused(SpotLamp{ glm::dvec3(0.0), glm::dvec3(1.0), 2.0, 1.0, 1.0 }, "half-angle 114");
  ExpectRefused(SpotLamp{ glm::dvec3(0.0), glm::dvec3(1.0), 1.0, -1.0, 1.0 }, "exponent -1");
  ExpectRefused(RectangleLamp{ glm::dvec3(0.0), glm::dvec3(1.0), -2.0, 1.0, 1.0 }, "width -2");
  ExpectRefused(RectangleLamp{ glm::dvec3(0.0), glm::dvec3(1.0), 2.0, 1.0, 1.0, glm::dvec3(1.0) },
    "lamp width's axis");
  ExpectRefused(RectangleLamp{ glm::dvec3(0.0), glm::dvec3(1.0), 2.0, 1.0, 1.0, { nan, 0.0, 0.0 } },
    "lamp width's axis");
  ExpectRefused(DiskLamp{ glm::dvec3(0.0), glm::dvec3(1.0), nan, 1.0 }, "radius");
  ExpectRefused(EmittingFacets{}, "no facet has an exitance");
}

// The photons' disk covers the scene and, for a sphere, is its shadow: no photon is wasted.
TEST(Emitter, ParallelLightStartsFromTheScenesShadow)
{
  Surface sphere = Shapes::Icosphere(4, Facing::Outward);
  sphere.metresPerUnit = 2.0;
  const Scene scene(sphere);
  const glm::dvec3 direction(1.0, -2.0, 0.5);
  const Emitter emitter(ParallelLight{ direction, 300.0 }, scene);
  const double shadow = Pi * 4.0;                     // m^2
  EXPECT_GE(emitter.Flux(), 300.0 * shadow * 0.995);  // the facets' shadow is a little smaller
  EXPECT_LE(emitter.Flux(), 300.0 * shadow * 1.0001); // float coordinates
  int missed = 0;
  ForPhotons(emitter, 1 << 14,
    [&](const Ray& ray)
    {
      EXPECT_NEAR(glm::dot(glm::dvec3(ray.direction), glm::normalize(direction)), 1.0, 1e-6);
      Hit hit;
      scene.Intersect(&ray, &hit, 1);
      missed += !hit;
    });
  EXPECT_LT(missed, (1 << 14) / 30);
}

TEST(Emitter, SpotStaysInItsCone)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  const double halfAngle = 0.3;
  for (const double exponent : { 0.0, 5.0 })
  {
    const Emitter emitter(
      SpotLamp{ glm::dvec3(0.1), glm::dvec3(0.0, 3.0, 0.0), halfAngle, exponent, 50.0 }, scene);
    EXPECT_EQ(emitter.Flux(), 50.0);
    double least = 1.0;
    ForPhotons(emitter, 1 << 12,
      [&](const Ray& ray)
      {
        least = std::min(least, double{ ray.direction.y });
        EXPECT_NEAR(glm::length(ray.origin - glm::vec3(0.05f)), 0.0f, 0.2f);
      });
    EXPECT_GE(least, std::cos(halfAngle) - 1e-6);
    EXPECT_LE(least, std::cos(halfAngle) + 0.01);
  }
}

// A rectangle that shines along x: its width runs along z x direction = y, its height along z.
TEST(Emitter, RectangleLiesAsDocumented)
{
  const Scene scene(Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Inward));
  const Emitter emitter(
    RectangleLamp{ glm::dvec3(-0.5, 0.0, 0.0), glm::dvec3(7.0, 0.0, 0.0), 0.8, 0.2, 10.0 }, scene);
  glm::vec3 low(1.0f), high(-1.0f);
  ForPhotons(emitter, 1 << 12,
    [&](const Ray& ray)
    {
      low = glm::min(low, ray.origin);
      high = glm::max(high, ray.origin);
      EXPECT_GE(ray.direction.x, 0.0f);
    });
  EXPECT_NEAR(high.x - low.x, 0.0f, 1e-6f);
  EXPECT_NEAR(high.y - low.y, 0.8f, 0.002f);
  EXPECT_NEAR(high.z - low.z, 0.2f, 0.002f);
}

// The same rectangle with its width along z instead: what is not in its plane does not count.
TEST(Emitter, RectangleIsAsWideAsTold)
{
  const Scene scene(Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Inward));
  const Emitter emitter(RectangleLamp{ glm::dvec3(-0.5, 0.0, 0.0), glm::dvec3(7.0, 0.0, 0.0), 0.8,
                          0.2, 10.0, glm::dvec3(5.0, 0.0, 3.0) },
    scene);
  glm::vec3 low(1.0f), high(-1.0f);
  ForPhotons(emitter, 1 << 12,
    [&](const Ray& ray)
    {
      low = glm::min(low, ray.origin);
      high = glm::max(high, ray.origin);
    });
  EXPECT_NEAR(high.x - low.x, 0.0f, 1e-6f);
  EXPECT_NEAR(high.y - low.y, 0.2f, 0.002f);
  EXPECT_NEAR(high.z - low.z, 0.8f, 0.002f);
}

TEST(Emitter, FacetsShineByTheirFlux)
{
  Surface box = Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Inward);
  box.exitance.assign(box.facets.size(), Colour(0.0f));
  box.exitance[2] = Colour(100.0f); // the two triangles of the top, 2 m^2 each
  box.exitance[3] = Colour(300.0f);
  box.metresPerUnit = 1.0;
  const Scene scene(box);
  const Emitter emitter(EmittingFacets{}, scene);
  EXPECT_NEAR(emitter.Flux(), 800.0, 1e-3);
  int onSecond = 0;
  constexpr int Photons = 1 << 12;
  ForPhotons(emitter, Photons,
    [&](const Ray& ray)
    {
      EXPECT_NEAR(ray.origin.z, 1.0f, 1e-5f);
      EXPECT_LT(ray.direction.z, 0.0f); // from the front, into the room
      // Rectangle() splits along the diagonal from its corner: the second triangle has y > x.
      onSecond += ray.origin.y > ray.origin.x;
    });
  EXPECT_NEAR(onSecond, Photons * 3 / 4, 3); // Sobol: discrepancy of the facet dimension
}

// A lamp that is far away lights the same points as one computed without rounding.
TEST(Emitter, FarLampsAimPrecisely)
{
  const Scene scene(Shapes::Box(glm::dvec3(-1.0), glm::dvec3(1.0), 1, Facing::Outward));
  const double far = 1e6;
  const Emitter emitter(
    SpotLamp{ glm::dvec3(0.0, 0.0, far), glm::dvec3(0.0, 0.0, -1.0), 2.0 / far, 0.0, 1.0 }, scene);
  ForPhotons(emitter, 1000,
    [&](const Ray& ray)
    {
      EXPECT_LE(glm::length(ray.origin), 3.0f);
      EXPECT_LE(std::fabs(ray.origin.x), 2.1f);
    });
}
