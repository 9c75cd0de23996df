// SPDX-License-Identifier: BSD-3-Clause
// The unified glare rating of CIE 117:1995.
#include "PhotonTransport/sensors/Glare.h"

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/sensors/SensorRun.h"

#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;

namespace
{

const glm::dvec3 Ahead(1.0, 0.0, 0.0), Up(0.0, 0.0, 1.0);

/// By the lengths of CIE 117: T aside, H above, at R = 1 ahead.
double Index(double aside, double above)
{
  return PositionIndex(glm::normalize(glm::dvec3(1.0, aside, above)), Ahead, Up);
}

constexpr double Rho = 0.5;

/// Within a luminaire of 2 or 3 degrees the position index varies.
constexpr double OfASmallOne = 0.03;

/// The readings of one sensor in the middle of an integrating sphere of radius 1 around a luminaire
/// of which nothing else is known.
SensorReading InASphere(const Lighting& lighting)
{
  const Scene scene(
    Shapes::WithReflectance(Shapes::Icosphere(4, Shapes::Facing::Inward), static_cast<float>(Rho)));
  TraceSettings settings;
  SensorRun run(scene, lighting, settings);
  EXPECT_TRUE(run.Trace(65536));
  std::vector<SensorReading> readings;
  EXPECT_TRUE(
    run.Read({ { glm::dvec3(0.0), Up } }, SensorDirections::From(Up, 0.0), 1024, {}, readings));
  return readings.front();
}

/// By the formula, for a small luminaire in a direction. What it gives the eye comes off the
/// illuminance there.
double Expected(
  double luminance, double solidAngle, const glm::dvec3& direction, const SensorReading& reading)
{
  const double direct = luminance * solidAngle * glm::dot(direction, Ahead);
  const double background = (reading.lux[Measure::Vertical] - direct) / Pi;
  const double index = PositionIndex(direction, Ahead, Up);
  return 8.0 * std::log10(0.25 / background * luminance * luminance * solidAngle / (index * index));
}

} // namespace

// Rows of the table of CIE 117, which has three digits.
TEST(Glare, PositionIndexIsThatOfTheTable)
{
  constexpr double OfTheTable = 0.02; // its own digits and how it was drawn
  EXPECT_EQ(Index(0.0, 0.0), 1.0);
  EXPECT_NEAR(Index(0.0, 0.5), 2.86, OfTheTable * 2.86);
  EXPECT_NEAR(Index(0.0, 1.0), 7.00, OfTheTable * 7.00);
  EXPECT_NEAR(Index(0.0, 1.5), 13.15, OfTheTable * 13.15);
  EXPECT_EQ(Index(0.3, -0.4), Index(0.3, 0.4));
  EXPECT_EQ(Index(-0.3, 0.4), Index(0.3, 0.4));
  EXPECT_EQ(PositionIndex(-Ahead, Ahead, Up), 0.0);
  EXPECT_EQ(PositionIndex(Up, Ahead, Up), 0.0);
}

TEST(Glare, OfASmallPanelIsThatOfTheFormula)
{
  DiskLamp panel;
  panel.centre = { 0.6, 0.0, 0.3 };
  panel.direction = { -0.6, 0.0, -0.3 };
  panel.radius = 0.02;
  panel.flux = 100.0;
  const SensorReading reading = InASphere(panel);
  const double area = Pi * 0.02 * 0.02;
  const double expected =
    Expected(100.0 / (Pi * area), area / (0.36 + 0.09), glm::normalize(panel.centre), reading);
  EXPECT_NEAR(reading.glare[0].ugr, expected, OfASmallOne);
  EXPECT_LT(reading.glare[0].standardError, 0.1);
  EXPECT_GT(expected, 20.0);
  EXPECT_EQ(reading.glare[2].ugr, 0.0);
}

TEST(Glare, OfAPhotometricFileIsThatOfItsLuminousOpening)
{
  PhotometricLamp lamp;
  lamp.position = { 0.6, 0.0, 0.3 };
  lamp.direction = { -0.6, 0.0, -0.3 };
  lamp.solid.polar = { 0.0, 90.0 };
  lamp.solid.azimuth = { 0.0, 360.0 };
  lamp.solid.candela = { 50.0, 0.0, 50.0, 0.0 };
  EXPECT_EQ(InASphere(lamp).glare[0].ugr, 0.0); // a point has no luminance
  lamp.solid.width = lamp.solid.length = 0.04;
  const SensorReading reading = InASphere(lamp);
  const double area = 0.04 * 0.04;
  const double expected =
    Expected(50.0 / area, area / (0.36 + 0.09), glm::normalize(lamp.position), reading);
  EXPECT_NEAR(reading.glare[0].ugr, expected, OfASmallOne);
}

TEST(Glare, StaysWithinItsRange)
{
  EXPECT_EQ(RatingOf({}, 10.0, 1.0).ugr, 0.0);
  EXPECT_EQ(RatingOf({ 1.0, 0.0 }, 0.0, 0.0).ugr, 100.0);
  EXPECT_EQ(RatingOf({ 1e-6, 0.0 }, 100.0, 1.0).ugr, 0.0);
  const GlareRating rating = RatingOf({ 1e6, 1e8 }, 100.0, 5.0);
  EXPECT_NEAR(rating.ugr, 8.0 * std::log10(0.25 * Pi * 1e4), 1e-9);
  EXPECT_NEAR(rating.standardError, 8.0 / std::log(10.0) * std::hypot(0.01, 0.05), 1e-9);
}
