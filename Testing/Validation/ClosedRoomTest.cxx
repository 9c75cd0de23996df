// SPDX-License-Identifier: BSD-3-Clause
// Interreflection in closed shapes: photon conservation, the furnace, no leaks.
#include "Comparison.h"
#include "Shapes.h"
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

struct Shape
{
  const char* name;
  Surface surface;
  glm::dvec3 lamp; ///< Inside.
};

std::ostream& operator<<(std::ostream& os, const Shape& shape)
{
  return os << shape.name;
}

std::vector<Shape> ClosedShapes()
{
  return {
    { "Box", Shapes::Box({ -2, -1, 0 }, { 2, 1, 1.5 }, 6, Facing::Inward), { 0.5, 0.2, 1.2 } },
    { "Sphere", Shapes::Icosphere(3, Facing::Inward), { 0.5, 0.2, -0.3 } },
    { "Torus", Shapes::Torus(40, 16, Facing::Inward), { 0.9, 0.1, 0.2 } },
    { "AcuteWedge", Shapes::Wedge(20.0, Facing::Inward), { 0.6, 0.1, 0.4 } },
  };
}

class ClosedShape : public testing::TestWithParam<Shape>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Validation, ClosedShape, testing::ValuesIn(ClosedShapes()),
  [](const auto& instance) { return instance.param.name; });

// Mean E = flux / (S (1 - rho)) in a closed room of any shape with the same reflectance everywhere.
// The number of hits of a photon is geometric, with variance rho / (1 - rho)^2: 4 standard
// deviations of its mean over all photons. Flat registration conserves it on any shape.
TEST_P(ClosedShape, MeanIlluminanceIsTheFurnaces)
{
  for (const float reflectance : { 0.0f, 0.5f, 0.9f, 0.95f })
  {
    const Surface surface = Shapes::WithReflectance(GetParam().surface, reflectance);
    const Scene scene(surface);
    double area = 0.0;
    for (const double a : scene.VertexAreas())
    {
      area += a;
    }
    TraceSettings settings;
    constexpr std::uint64_t Photons = 500'000;
    settings.registration = Registration::Flat;
    const TracedMap map(scene, PointLamp{ GetParam().lamp, 1000.0 }, settings, Photons);
    const double rho = reflectance;
    const double exact = 1000.0 / (area * (1.0 - rho));
    const double spread = std::sqrt(rho / static_cast<double>(Photons)); // relative
    constexpr double Rounding = 1e-6;                                    // float weights
    EXPECT_NEAR(AreaMean(scene, Total(map.front)) / exact, 1.0, 4.0 * spread + Rounding);
    EXPECT_EQ(map.balance.escaped, 0u);
    EXPECT_EQ(map.balance.cutOff, 0u);
  }
}

// On flat walls the compensated registrations are Flat.
TEST(Box, EveryRegistrationGivesTheFurnacesMean)
{
  const Surface surface =
    Shapes::WithReflectance(Shapes::Box({ -2, -1, 0 }, { 2, 1, 1.5 }, 6, Facing::Inward), 0.9f);
  const Scene scene(surface);
  const double exact = 1000.0 / (2.0 * (8.0 + 6.0 + 3.0) * 0.1);
  for (const int kind : { 0, 1, 2 })
  {
    TraceSettings settings;
    settings.registration = static_cast<Registration>(kind);
    const TracedMap map(scene, PointLamp{ { 0.5, 0.2, 1.2 }, 1000.0 }, settings, 1'000'000);
    EXPECT_NEAR(AreaMean(scene, Total(map.front)) / exact, 1.0, 4.0 * std::sqrt(0.9 / 1e6) + 1e-5);
  }
}

// 10^7 photons in each closed shape: none escapes, none is seen from the outside.
TEST_P(ClosedShape, DoesNotLeak)
{
  const Scene scene(Shapes::WithReflectance(GetParam().surface, 0.5f));
  TraceSettings settings;
  settings.registerBackSide = true;
  settings.registration = Registration::Flat;
  const TracedMap map(scene, PointLamp{ GetParam().lamp, 1000.0 }, settings, 10'000'000);
  EXPECT_EQ(map.balance.escaped, 0u);
  EXPECT_EQ(map.balance.absorbed, map.balance.emitted);
  for (const double back : Total(map.back))
  {
    EXPECT_EQ(back, 0.0);
  }
}
