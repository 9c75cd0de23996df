// SPDX-License-Identifier: BSD-3-Clause
// Is the standard error true? Many seeds of scenes with a known answer: the error over the standard
// error of R replicates is Student's t with R - 1 degrees of freedom where the replicates are
// normal, so its mean square is (R - 1)/(R - 3) and 95 % of it lies within the t interval.
#include "Comparison.h"
#include "Shapes.h"
#include "TracedMap.h"

#include <boost/math/distributions/students_t.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <tuple>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr int Seeds = 64;
constexpr double Replicates = 8.0;

struct CalibrationScene
{
  std::string name;
  Surface surface;
  Lamp lamp;
  std::vector<double> expected[3]; ///< [registration][vertex], lx
  std::uint64_t photons;
};

std::ostream& operator<<(std::ostream& os, const CalibrationScene& scene)
{
  return os << scene.name;
}

/// A floor under a point lamp: flat, so that every registration expects the mean over the ring.
CalibrationScene FloorUnderPointLamp()
{
  CalibrationScene scene{ "Floor", Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 8),
    PointLamp{ { 0.2, 0.1, 1.0 }, 1000.0 }, {}, 20'000 };
  const auto illuminance = [](const glm::dvec3& point, const glm::dvec3& normal)
  {
    const glm::dvec3 ray = point - glm::dvec3(0.2, 0.1, 1.0);
    const double d = glm::length(ray);
    return 1000.0 / (4.0 * 3.14159265358979) * -glm::dot(ray, normal) / (d * d * d);
  };
  for (std::vector<double>& expected : scene.expected)
  {
    expected = RingMeans(scene.surface, illuminance);
  }
  return scene;
}

/// A coarse sphere under parallel light: what each registration expects differs.
CalibrationScene SphereUnderParallelLight()
{
  const ParallelLight light{ { 0.3, 0.2, -1.0 }, 1000.0 };
  const glm::dvec3 towards = -glm::normalize(light.direction);
  CalibrationScene scene{ "Sphere", Shapes::Icosphere(1, Facing::Outward), light, {}, 20'000 };
  const auto flat = [=](const glm::dvec3&, const glm::dvec3& normal)
  { return 1000.0 * std::max(0.0, glm::dot(towards, normal)); };
  scene.expected[0] = RingMeans(scene.surface, flat);
  for (const glm::dvec3& normal : scene.surface.normals)
  {
    scene.expected[2].push_back(1000.0 * std::max(0.0, glm::dot(towards, normal)));
  }
  // The interpolated normal of a sphere about the origin points along the hit; 16 is the bound.
  scene.expected[1] = RingMeans(scene.surface,
    [=](const glm::dvec3& point, const glm::dvec3& normal)
    {
      const double cosSmooth = glm::dot(towards, glm::normalize(point));
      const double cosFlat = glm::dot(towards, normal);
      return 1000.0 * std::max(0.0, std::min(cosSmooth, 16.0 * cosFlat));
    });
  return scene;
}

/// A closed box whose walls shine and reflect: E = M / (1 - rho) everywhere, most of it indirect.
CalibrationScene Furnace()
{
  const Surface box = Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 3, Facing::Inward);
  CalibrationScene scene{ "Furnace",
    Shapes::WithExitance(Shapes::WithReflectance(box, 0.75f), 100.0f), EmittingFacets{}, {},
    20'000 };
  for (std::vector<double>& expected : scene.expected)
  {
    expected.assign(box.points.size(), 400.0);
  }
  return scene;
}

using Parameters = std::tuple<CalibrationScene, Registration, Sampling>;

class Calibration : public testing::TestWithParam<Parameters>
{
};

std::string NameOf(const testing::TestParamInfo<Parameters>& instance)
{
  constexpr const char* Registrations[] = { "Flat", "FacetRatio", "VertexNormalised" };
  constexpr const char* Samplings[] = { "Random", "Sobol" };
  return std::get<0>(instance.param).name +
    Registrations[static_cast<int>(std::get<1>(instance.param))] +
    Samplings[static_cast<int>(std::get<2>(instance.param))];
}

/// Mean over seeds and its standard error.
struct SeedMean
{
  double mean;
  double error;
};

SeedMean MeanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  const double count = static_cast<double>(values.size());
  const double mean = sum / count;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return { mean, std::sqrt(squares / (count - 1.0) / count) };
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Validation, Calibration,
  testing::Combine(testing::Values(FloorUnderPointLamp(), SphereUnderParallelLight(), Furnace()),
    testing::Values(Registration::Flat, Registration::FacetRatio, Registration::VertexNormalised),
    testing::Values(Sampling::Random, Sampling::Sobol)),
  NameOf);

TEST_P(Calibration, ErrorIsWhatTheStandardErrorSays)
{
  const auto& [scene, registration, sampling] = GetParam();
  const std::vector<double>& expected = scene.expected[static_cast<int>(registration)];
  const Scene prepared(scene.surface);
  const boost::math::students_t student(Replicates - 1.0);
  const double within = boost::math::quantile(student, 0.975);
  std::vector<double> squares;
  std::vector<double> coverage;
  for (int seed = 1; seed <= Seeds; ++seed)
  {
    TraceSettings settings;
    settings.registration = registration;
    settings.sampling = sampling;
    settings.seed = static_cast<std::uint32_t>(seed);
    const TracedMap map(prepared, scene.lamp, settings, scene.photons);
    double sum = 0.0;
    double inside = 0.0;
    double count = 0.0;
    for (std::size_t v = 0; v < expected.size(); ++v)
    {
      // Replicates need some hits to be normal, and a vertex turned away has no error.
      if (map.front.photonHits[v] < 100 || expected[v] <= 0.0)
      {
        continue;
      }
      const double error = map.front.direct[v] + map.front.indirect[v] - expected[v];
      const double t = error / map.front.standardError[v];
      sum += t * t;
      inside += std::fabs(t) <= within;
      count += 1.0;
    }
    squares.push_back(sum / count);
    coverage.push_back(inside / count);
  }
  const SeedMean square = MeanOf(squares);
  const SeedMean covered = MeanOf(coverage);
  std::printf(
    "  mean of (error/SE)^2 %.3f +- %.3f (expected %.3f), 95 %% interval covers %.1f %%\n",
    square.mean, square.error, (Replicates - 1.0) / (Replicates - 3.0), 100.0 * covered.mean);
  EXPECT_NEAR(square.mean, (Replicates - 1.0) / (Replicates - 3.0), 4.0 * square.error);
  EXPECT_GE(covered.mean, 0.93);
  EXPECT_LE(covered.mean, 0.97);
}
