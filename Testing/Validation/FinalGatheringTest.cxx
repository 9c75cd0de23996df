// SPDX-License-Identifier: BSD-3-Clause
// The second pass where its result has a closed form: black surfaces, the furnace.
#include "GatheringTools.h"
#include "References.h"
#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

using namespace PhotonTransport;
using References::Pi;
using Shapes::Facing;

namespace
{

/// Of sums of single precision: places are rounded to 2^-24 of the scene's size, and an illuminance
/// takes a few operations.
constexpr double FloatRounding = 16.0 * 0x1p-24;

Surface Floor()
{
  return Shapes::Rectangle({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 8);
}

/// Direct light is that of a closed form at the vertex, and there is no other.
/// @param tolerance Relative.
void ExpectDirect(const Lamp& lamp, double tolerance,
  const std::function<double(const glm::dvec3& point, const glm::dvec3& normal)>& exact)
{
  const Surface floor = Floor();
  const Scene scene(floor);
  const IlluminationMap map = GatheredFront(scene, lamp, GatheringSettings(16), 4096);
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    const double expected = exact(floor.points[v], glm::normalize(floor.normals[v]));
    EXPECT_NEAR(map.direct[v], expected, tolerance * expected) << v;
    EXPECT_EQ(map.indirect[v], 0.0) << v;
    EXPECT_EQ(map.caustic[v], 0.0) << v;
    EXPECT_EQ(map.standardError[v], 0.0) << "nothing is left to chance at " << v;
  }
}

} // namespace

// E = I cos / d^2
TEST(FinalGathering, PointLampOverABlackFloor)
{
  const glm::dvec3 lamp(0.3, -0.2, 1.0);
  ExpectDirect(PointLamp{ lamp, 1000.0 }, FloatRounding,
    [&](const glm::dvec3& point, const glm::dvec3& normal)
    {
      const double d = glm::length(lamp - point);
      return 1000.0 / (4.0 * Pi) * glm::dot(lamp - point, normal) / (d * d * d);
    });
}

// Lambert's formula for the polygon. It is that of a place within a facet, up to three thousandths
// of the way from the vertex to its middle, which is 0.24 away. Light varies by 2 / distance at
// most, relative to itself, and the panel is 1 away.
TEST(FinalGathering, PanelOverABlackFloor)
{
  const RectangleLamp panel{ { 0.5, -0.25, 1.0 }, { 0, 0, -1 }, 1.0, 0.5, 1000.0 };
  const std::vector<glm::dvec3> corners{ { 0.0, -0.5, 1.0 }, { 1.0, -0.5, 1.0 }, { 1.0, 0.0, 1.0 },
    { 0.0, 0.0, 1.0 } };
  constexpr double Within = 3e-3 * 0.24 * 2.0 + FloatRounding;
  ExpectDirect(panel, Within,
    [&](const glm::dvec3& point, const glm::dvec3& normal)
    { return 1000.0 / 0.5 * References::ConfigurationFactor(point, normal, corners); });
}

namespace
{

struct Oven
{
  const char* name;
  Surface surface;
};

std::ostream& operator<<(std::ostream& os, const Oven& oven)
{
  return os << oven.name;
}

class Furnace : public testing::TestWithParam<Oven>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(FinalGathering, Furnace,
  testing::Values(Oven{ "Box", Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 3, Facing::Inward) },
    Oven{ "Octasphere", Shapes::Octasphere(2, Facing::Inward) },
    Oven{ "Icosphere", Shapes::Icosphere(2, Facing::Inward) }),
  [](const auto& instance) { return std::string(instance.param.name); });

// Walls that shine and reflect: E = M / (1 - rho) everywhere. Three quarters of the light is
// gathered.
TEST_P(Furnace, IsEquallyBrightEverywhere)
{
  constexpr std::uint32_t Seeds = 8;
  constexpr double Exact = 100.0 / (1.0 - 0.75);
  const Scene scene(
    Shapes::WithExitance(Shapes::WithReflectance(GetParam().surface, 0.75f), 100.0f));
  std::vector<std::vector<double>> values, errors;
  double deviation = 0.0;
  for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
  {
    const IlluminationMap map =
      GatheredFront(scene, EmittingFacets{}, GatheringSettings(64, seed), 100'000);
    values.push_back(map.direct);
    errors.push_back(map.standardError);
    for (std::size_t v = 0; v < map.direct.size(); ++v)
    {
      values.back()[v] += map.indirect[v];
      deviation += std::pow(values.back()[v] / Exact - 1.0, 2.0) / Seeds;
    }
  }
  const std::size_t vertices = values.front().size();
  const std::vector<double> exact(vertices, Exact);
  const ToldErrors told = CompareWithTold(values, errors, exact);
  std::printf("  RMS error %.2f %%, mean of (error/SE)^2 %.3f +- %.3f, largest mean %.2f\n",
    100.0 * std::sqrt(deviation / static_cast<double>(vertices)), told.square.mean,
    told.square.error, told.largest);
  RecordProperty("squares", std::to_string(told.square.mean));
  // Errors are normal where rays make them, whose variance is well known, and Student's t of eight
  // replicates, of the variance 7/5, where photons do. Stratified rays err less than they tell.
  EXPECT_LE(told.square.mean, 1.4 + 3.0 * told.square.error);
  EXPECT_GE(told.square.mean, 0.5) << "the errors that are told are too large to mean anything";
  // No vertex is off. The mean of eight t of 7 degrees of freedom exceeds 5 of its standard errors
  // with a chance below 1e-5.
  EXPECT_LT(told.largest, 5.0);
}
