// SPDX-License-Identifier: BSD-3-Clause
// Sensors: what they measure against closed forms, against maps, and their errors.
#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/lights/LambertPolygon.h"
#include "PhotonTransport/sensors/SensorRun.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include "Shapes.h"
#include "TracedMap.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint32_t Rays = 1024;
const glm::dvec3 Up(0.0, 0.0, 1.0);

TraceSettings SettingsFor(std::uint32_t seed, int threads = 0)
{
  TraceSettings settings;
  settings.seed = seed;
  settings.threads = threads;
  settings.method = Method::FinalGathering;
  return settings;
}

std::vector<SensorReading> ReadingsOf(const Scene& scene, const Lighting& lighting,
  const std::vector<Sensor>& sensors, std::uint64_t photons = 16384,
  const TraceSettings& settings = SettingsFor(1), const Openings& openings = {},
  const SensorDirections& directions = SensorDirections::From(Up, 0.0))
{
  SensorRun run(scene, lighting, settings, openings);
  EXPECT_TRUE(run.Trace(photons));
  std::vector<SensorReading> readings;
  EXPECT_TRUE(run.Read(sensors, directions, Rays, {}, readings));
  return readings;
}

/// A black triangle that is too small and too far off to matter, for scenes without a surface.
Surface Speck()
{
  return Shapes::Rectangle(
    glm::dvec3(0.0, 0.0, -1e3), glm::dvec3(1e-3, 0.0, 0.0), glm::dvec3(0.0, 1e-3, 0.0), 1);
}

/// The integral over all directions of luminance(direction) times each kernel, by the midpoint
/// rule.
Measured<double> Integral(const glm::dvec3& normal, const SensorDirections& directions,
  const std::function<double(const glm::dvec3&)>& luminance)
{
  constexpr int Rings = 400, Steps = 800;
  Measured<double> sum{};
  for (int i = 0; i < Rings; ++i)
  {
    const double z = 1.0 - (i + 0.5) * 2.0 / Rings;
    for (int j = 0; j < Steps; ++j)
    {
      const double angle = (j + 0.5) * 2.0 * Pi / Steps;
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
      const Measured<float> kernels = KernelsAt(direction, normal, directions);
      for (std::size_t k = 0; k < sum.size(); ++k)
      {
        sum[k] += luminance(direction) * double{ kernels[k] } * 4.0 * Pi / (Rings * Steps);
      }
    }
  }
  return sum;
}

double Overcast(const glm::dvec3& direction) // CIE, 1:3
{
  return direction.z > 0.0 ? (1.0 + 2.0 * direction.z) / 3.0 : 0.0;
}

/// Mean square of error over standard error, over all sensors and measures.
double MeanSquare(const std::vector<SensorReading>& readings, const Measured<double>& exact)
{
  double sum = 0.0;
  for (const SensorReading& reading : readings)
  {
    for (std::size_t k = 0; k < exact.size(); ++k)
    {
      sum += std::pow((reading.lux[k] - exact[k]) / reading.standardError[k], 2.0);
    }
  }
  return sum / static_cast<double>(readings.size() * exact.size());
}

} // namespace

// Shares of the horizontal illuminance under an open sky, in closed form: uniform, and CIE overcast
// with E_h = 7 pi / 9 of the zenith's luminance, whose vertical part is (3 pi + 8) / (14 pi).
TEST(Sensors, KernelsHaveTheirClosedFormsUnderSkies)
{
  const SensorDirections directions = SensorDirections::From(Up, 0.0);
  const Measured<double> uniform =
    Integral(Up, directions, [](const glm::dvec3& d) { return d.z > 0.0 ? 1.0 : 0.0; });
  const Measured<double> overcast = Integral(Up, directions, Overcast);
  const Measured<double> everywhere =
    Integral(Up, directions, [](const glm::dvec3&) { return 1.0; });
  const double vertical = (3.0 * Pi + 8.0) / (14.0 * Pi); // .39618
  const auto expect = [](const Measured<double>& found, double scale, double ofVertical,
                        double hemispherical, double spherical)
  {
    constexpr double Quadrature = 5e-5;
    EXPECT_NEAR(found[Measure::Horizontal] / scale, 1.0, Quadrature);
    EXPECT_NEAR(found[Measure::Own] / scale, 1.0, Quadrature);
    EXPECT_NEAR(found[Measure::Cylindrical] / scale, ofVertical, Quadrature);
    EXPECT_NEAR(found[Measure::Hemispherical] / scale, hemispherical, Quadrature);
    EXPECT_NEAR(found[Measure::Spherical] / scale, spherical, Quadrature);
    for (std::size_t v = 0; v < SensorDirections::Views; ++v)
    {
      EXPECT_NEAR(found[Measure::Vertical + v] / scale, ofVertical, Quadrature);
      EXPECT_NEAR(found[Measure::Semicylindrical + v] / scale, ofVertical, Quadrature);
    }
  };
  expect(uniform, Pi, 0.5, 0.75, 0.5);
  expect(overcast, 7.0 / 9.0 * Pi, vertical, 19.0 / 28.0, 3.0 / 7.0);
  expect(everywhere, Pi, 1.0, 1.0, 1.0);
}

TEST(Sensors, MeasureAnOpenSkyAndTellTheirErrors)
{
  const Scene scene(Speck());
  CieSky sky;
  sky.type = 16;
  sky.horizontalIlluminance = 10000.0;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, 2.0));
  const std::vector<Sensor> sensors(64, { glm::dvec3(0.0), normal });
  const auto readings = ReadingsOf(scene, sky, sensors);
  const SensorDirections directions = SensorDirections::From(Up, 0.0);
  const Measured<double> exact = Integral(normal, directions,
    [](const glm::dvec3& d) { return 10000.0 * 9.0 / (7.0 * Pi) * Overcast(d); });
  for (const SensorReading& reading : readings)
  {
    EXPECT_TRUE(reading.valid);
    for (std::size_t k = 0; k < exact.size(); ++k)
    {
      EXPECT_LT(reading.standardError[k], 0.02 * exact[k]);
      EXPECT_EQ(reading.glare[0].ugr, 0.0); // a sky is no luminaire
    }
  }
  const double square = MeanSquare(readings, exact);
  EXPECT_GT(square, 0.5);
  EXPECT_LT(square, 1.5);
}

// E = I cos / d^2 and its kin: one ray, and no noise.
TEST(Sensors, MeasureAPointLampWithoutNoise)
{
  const Scene scene(Speck());
  PointLamp lamp;
  lamp.position = { 3.0, 0.0, 4.0 };
  lamp.flux = 4.0 * Pi * 500.0; // 500 cd
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
  const SensorReading reading = ReadingsOf(scene, lamp, { { glm::dvec3(0.0), normal } }).front();
  const double across = 500.0 / 25.0; // of a surface that faces the lamp
  const double sine = 0.6, cosine = 0.8;
  const auto expect = [&](std::size_t measure, double kernel)
  {
    EXPECT_NEAR(reading.lux[measure], across * kernel, 1e-5 * across) << measure;
    EXPECT_EQ(reading.standardError[measure], 0.0) << measure;
  };
  expect(Measure::Horizontal, cosine);
  expect(Measure::Own, (sine + cosine) / std::sqrt(2.0));
  expect(Measure::Vertical, sine);
  expect(Measure::Vertical + 1, 0.0);
  expect(Measure::Vertical + 2, 0.0);
  expect(Measure::Cylindrical, sine / Pi);
  expect(Measure::Semicylindrical, 2.0 * sine / Pi);
  expect(Measure::Semicylindrical + 1, sine / Pi);
  expect(Measure::Semicylindrical + 2, 0.0);
  expect(Measure::Hemispherical, (1.0 + cosine) / 4.0);
  expect(Measure::Spherical, 0.25);
}

TEST(Sensors, MeasureAPanelAsLambertsFormulaSays)
{
  const Scene scene(Speck());
  RectangleLamp panel;
  panel.centre = { 0.5, 0.2, 1.0 };
  panel.direction = { 0.0, 0.0, -1.0 };
  panel.width = 1.2;
  panel.height = 0.6;
  const std::vector<Sensor> sensors(64, { glm::dvec3(0.0), Up });
  const auto readings = ReadingsOf(scene, panel, sensors);
  const RectangleLamp::PanelAxes axes = panel.Axes();
  const glm::dvec3 u = 0.5 * panel.width * axes.width, v = 0.5 * panel.height * axes.height;
  const glm::dvec3 c = panel.centre;
  const auto lux = [&](const glm::dvec3& normal)
  {
    return ConfigurationFactor({ c - u - v, c + u - v, c + u + v, c - u + v }, normal) *
      panel.flux / (panel.width * panel.height);
  };
  const SensorDirections directions = SensorDirections::From(Up, 0.0);
  double squares = 0.0;
  for (const SensorReading& reading : readings)
  {
    const auto error = [&](std::size_t k, double exact)
    {
      EXPECT_LT(reading.standardError[k], 0.01 * exact);
      return (reading.lux[k] - exact) / reading.standardError[k];
    };
    squares += std::pow(error(Measure::Horizontal, lux(Up)), 2.0);
    squares += std::pow(error(Measure::Vertical, lux(directions.views[0])), 2.0);
  }
  // Two estimates of one sensor share their samples.
  EXPECT_NEAR(squares / 128.0, 1.0, 4.0 * std::sqrt(2.0 / 64.0));
}

// In a sphere that reflects evenly the indirect light is the same everywhere and in all directions:
// each measure of it is flux rho / (area (1 - rho)).
TEST(Sensors, MeasureTheEvenLightOfAnIntegratingSphere)
{
  constexpr double Rho = 0.6;
  const Scene scene(
    Shapes::WithReflectance(Shapes::Icosphere(4, Facing::Inward), static_cast<float>(Rho)));
  PointLamp lamp;
  lamp.flux = 1000.0;
  double area = 0.0;
  for (const double a : scene.VertexAreas())
  {
    area += a;
  }
  const double indirect = lamp.flux * Rho / (area * (1.0 - Rho));
  const glm::dvec3 place(0.3, -0.2, 0.1);
  const SensorDirections directions = SensorDirections::From(Up, 0.7);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-1.0, 0.5, 0.3));
  const glm::dvec3 toLamp = glm::normalize(-place);
  const Measured<float> kernels = KernelsAt(toLamp, normal, directions);
  Measured<double> exact;
  for (std::size_t k = 0; k < exact.size(); ++k)
  {
    exact[k] = indirect + double{ kernels[k] } * 1000.0 / (4.0 * Pi) / glm::dot(place, place);
  }
  double squares = 0.0;
  constexpr std::uint32_t Seeds = 6;
  for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
  {
    const auto readings = ReadingsOf(scene, lamp, std::vector<Sensor>(8, { place, normal }), 16384,
      SettingsFor(seed), {}, directions);
    for (const SensorReading& reading : readings)
    {
      for (std::size_t k = 0; k < exact.size(); ++k)
      {
        EXPECT_LT(reading.standardError[k], 0.06 * indirect);
      }
    }
    squares += MeanSquare(readings, exact) / Seeds;
  }
  EXPECT_GT(squares, 0.4);
  EXPECT_LT(squares, 2.0); // the facets' light differs a little from that of the sphere
}

// A sensor on the surface measures what a map by final gathering has there.
TEST(Sensors, AgreeWithAMapByFinalGathering)
{
  const Surface room = Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(0.0), glm::dvec3(4.0, 4.0, 3.0), 2, Facing::Inward), 0.6f);
  const Scene scene(room);
  DiskLamp lamp;
  lamp.centre = { 1.5, 2.2, 2.6 };
  lamp.radius = 0.3;
  TraceSettings settings = SettingsFor(1);
  settings.gatherRays = Rays;
  const TracedMap map(scene, lamp, settings, 65536);
  std::vector<Sensor> sensors;
  for (std::size_t p = 0; p < room.points.size(); ++p)
  {
    sensors.push_back({ room.points[p], room.normals[p] });
  }
  const auto readings = ReadingsOf(scene, lamp, sensors, 65536, SettingsFor(2));
  double squares = 0.0;
  int inside = 0;
  for (std::size_t p = 0; p < sensors.size(); ++p)
  {
    const glm::dvec3 fromMiddle = glm::abs(room.points[p] - glm::dvec3(2.0, 2.0, 1.5));
    const bool onEdge = (fromMiddle.x > 1.9) + (fromMiddle.y > 1.9) + (fromMiddle.z > 1.4) > 1;
    if (!onEdge) // the map's own places are a little within the facets there
    {
      const double error =
        std::hypot(map.front.standardError[p], readings[p].standardError[Measure::Own]);
      const double difference =
        readings[p].lux[Measure::Own] - map.front.direct[p] - map.front.indirect[p];
      squares += std::pow(difference / error, 2.0);
      EXPECT_LT(error, 0.03 * readings[p].lux[Measure::Own]);
      ++inside;
    }
    EXPECT_TRUE(readings[p].valid);
  }
  ASSERT_EQ(inside, 6);
  EXPECT_LT(squares / inside, 16.0 / 6.0); // chi^2 of 6: once in 100
}

TEST(Sensors, MeasureTheSameDaylightWithAndWithoutItsOpening)
{
  const Surface room =
    Shapes::WithReflectance(Shapes::RoomWithWindow(4.0, 3.0, { -0.7, 0.9, 0.6, 2.4 }, 4), 0.5f);
  const Scene scene(room);
  CieSky sky;
  sky.type = 16;
  const TraceSettings settings = SettingsFor(3);
  const FoundOpenings found = OpeningsToSkies(room, scene, sky, settings);
  ASSERT_EQ(found.openings.List().size(), 1u);
  std::vector<Sensor> sensors;
  for (double y = -1.5; y < 2.0; y += 0.5)
  {
    sensors.push_back({ { 0.3, y, 0.85 }, Up });
  }
  const auto with = ReadingsOf(scene, sky, sensors, 16384, settings, found.openings);
  double squares = 0.0;
  std::vector<Measured<double>> sums(sensors.size());
  // Without the opening the light is the same, with more noise.
  constexpr int Runs = 4;
  std::vector<Measured<double>> variances(sensors.size());
  for (int run = 0; run < Runs; ++run)
  {
    const auto without = ReadingsOf(scene, sky, sensors, 16384, SettingsFor(10 + run));
    for (std::size_t i = 0; i < sensors.size(); ++i)
    {
      for (std::size_t k = 0; k < Measure::Number; ++k)
      {
        sums[i][k] += without[i].lux[k] / Runs;
        variances[i][k] += std::pow(without[i].standardError[k] / Runs, 2.0);
      }
    }
  }
  for (std::size_t i = 0; i < sensors.size(); ++i)
  {
    for (std::size_t k = 0; k < Measure::Number; ++k)
    {
      const double error = std::sqrt(variances[i][k] + std::pow(with[i].standardError[k], 2.0));
      squares += std::pow((with[i].lux[k] - sums[i][k]) / error, 2.0);
      EXPECT_LT(error, 0.1 * with[i].lux[k]) << i << " " << k;
    }
  }
  EXPECT_LT(squares / static_cast<double>(sensors.size() * Measure::Number), 2.5);
}

TEST(Sensors, MarkPointsInsideSolids)
{
  Surface room = Shapes::WithReflectance(
    Shapes::Together(Shapes::Box(glm::dvec3(0.0), glm::dvec3(4.0, 4.0, 3.0), 2, Facing::Inward),
      Shapes::Box(glm::dvec3(1.0), glm::dvec3(2.0), 1, Facing::Outward)),
    0.5f);
  const Scene scene(room);
  PointLamp lamp;
  lamp.position = { 3.0, 3.0, 2.0 };
  const auto readings = ReadingsOf(scene, lamp,
    { { glm::dvec3(0.5), Up }, { glm::dvec3(1.5), Up }, { { 2.0, 2.0, -0.5 }, Up },
      { { 1.5, 1.5, 2.0 }, Up }, { { 9.0, 2.0, 1.0 }, Up } });
  EXPECT_TRUE(readings[0].valid);
  EXPECT_FALSE(readings[1].valid); // in the box
  EXPECT_FALSE(readings[2].valid); // below the floor
  EXPECT_TRUE(readings[3].valid);  // on the box
  EXPECT_FALSE(readings[4].valid); // outside
  EXPECT_EQ(readings[1].lux, Measured<double>{});
  EXPECT_GT(readings[3].lux[Measure::Own], readings[3].lux[Measure::Vertical + 2]);
}

TEST(Sensors, HaveTheSameBitsOnAnyNumberOfThreads)
{
  const Scene scene(Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(0.0), glm::dvec3(4.0, 4.0, 3.0), 2, Facing::Inward), 0.5f));
  DiskLamp lamp;
  lamp.centre = { 1.5, 2.2, 2.9 };
  std::vector<Sensor> sensors;
  for (int i = 1; i < 20; ++i)
  {
    sensors.push_back({ { 0.2 * i, 1.0, 1.0 }, Up });
  }
  const auto one = ReadingsOf(scene, lamp, sensors, 16384, SettingsFor(1, 1));
  const auto three = ReadingsOf(scene, lamp, sensors, 16384, SettingsFor(1, 3));
  for (std::size_t i = 0; i < sensors.size(); ++i)
  {
    EXPECT_EQ(one[i].lux, three[i].lux);
    EXPECT_EQ(one[i].standardError, three[i].standardError);
  }
}

TEST(Sensors, TellHowMuchLightTheyMissForMirrors)
{
  Surface room = Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(0.0), glm::dvec3(4.0, 4.0, 3.0), 2, Facing::Inward), 0.5f);
  const Scene matt(room);
  PointLamp lamp;
  lamp.position = { 2.0, 2.0, 2.0 };
  SensorRun without(matt, lamp, SettingsFor(1));
  EXPECT_EQ(without.Caustics().Value(), 0.0);
  without.Trace(16384);
  EXPECT_EQ(without.Caustics().Value(), 0.0);
  for (Material& material : room.materials)
  {
    material.diffuseReflectance = Colour(0.0f);
    material.specularReflectance = Colour(0.5f);
  }
  const Scene mirrors(room);
  SensorRun with(mirrors, lamp, SettingsFor(1));
  with.Trace(16384);
  EXPECT_NEAR(with.Caustics().Value(), 0.5, 0.01); // 1/2 + 1/4 + ... over 1 + 1/2 + 1/4 + ...
}
