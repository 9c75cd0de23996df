// SPDX-License-Identifier: BSD-3-Clause
// Grids of sensors by EN 12464-1.
#include "PhotonTransport/sensors/SensorGrid.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace PhotonTransport;

namespace
{

const SensorDirections Level = SensorDirections::From({ 0.0, 0.0, 1.0 }, 0.0);

std::vector<AreaTriangle> RectangleAt(double x0, double y0, double x1, double y1, double z = 0.0)
{
  const glm::dvec3 a(x0, y0, z), b(x1, y0, z), c(x1, y1, z), d(x0, y1, z);
  return { { a, b, c }, { a, c, d } };
}

std::vector<AreaTriangle> Together(std::vector<AreaTriangle> a, const std::vector<AreaTriangle>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string ErrorOf(const std::vector<AreaTriangle>& area, const GridSettings& settings)
{
  try
  {
    GridOver(area, Level, settings);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(SensorGrid, HasTheSpacingOfTheStandard)
{
  EXPECT_NEAR(GridSpacing(1.0, 1.0), 0.2, 1e-12);
  EXPECT_NEAR(GridSpacing(10.0, 8.0), 1.0, 1e-12);
  EXPECT_NEAR(GridSpacing(100.0, 60.0), 5.0, 1e-12);
  EXPECT_NEAR(GridSpacing(8.0, 10.0), 1.0, 1e-12);
  EXPECT_NEAR(GridSpacing(50.0, 10.0), 1.0, 1e-12); // the shorter side, as it is long
  EXPECT_EQ(GridSpacing(1e4, 1e4), 10.0);
  // Numbers of points along d in the table of the standard.
  EXPECT_EQ(GridCells(1.0, 1.0, 0.0)[0], 5u);
  EXPECT_EQ(GridCells(2.0, 2.0, 0.0)[0], 6u);
  EXPECT_EQ(GridCells(5.0, 5.0, 0.0)[0], 8u);
  EXPECT_EQ(GridCells(10.0, 10.0, 0.0)[0], 10u);
  EXPECT_EQ(GridCells(100.0, 100.0, 0.0)[0], 20u);
}

TEST(SensorGrid, HasCellsThatAreNearlySquare)
{
  for (const double length : { 0.3, 1.0, 3.7, 12.0, 40.0 })
  {
    for (const double width : { 0.3, 1.0, 3.7, 12.0, 40.0 })
    {
      for (const double spacing : { 0.0, 0.25 })
      {
        const auto cells = GridCells(length, width, spacing);
        const double ratio =
          length / static_cast<double>(cells[0]) * static_cast<double>(cells[1]) / width;
        EXPECT_GT(ratio, 0.5) << length << " " << width;
        EXPECT_LT(ratio, 2.0) << length << " " << width;
        EXPECT_EQ(GridCells(width, length, spacing)[1], cells[0]);
      }
    }
  }
}

TEST(SensorGrid, LiesAboveARectangleWithoutItsMargin)
{
  GridSettings settings;
  settings.height = 0.8;
  const SensorGrid grid = GridOver(RectangleAt(-1.0, 2.0, 5.0, 6.0, 0.1), Level, settings);
  const auto cells = GridCells(5.0, 3.0, 0.0);
  EXPECT_EQ(grid.cells, cells);
  EXPECT_EQ(grid.sensors.size(), cells[0] * cells[1]);
  EXPECT_NEAR(grid.cellArea * static_cast<double>(grid.sensors.size()), 15.0, 1e-9);
  for (const Sensor& sensor : grid.sensors)
  {
    EXPECT_NEAR(sensor.position.z, 0.9, 1e-12);
    EXPECT_GT(sensor.position.x, -0.5);
    EXPECT_LT(sensor.position.x, 4.5);
    EXPECT_GT(sensor.position.y, 2.5);
    EXPECT_LT(sensor.position.y, 5.5);
    EXPECT_EQ(sensor.normal, Level.up);
  }
}

// Lengths of settings are metres, whatever the unit of the data.
TEST(SensorGrid, IsTheSameInMillimetres)
{
  GridSettings settings;
  const SensorGrid metres = GridOver(RectangleAt(0.0, 0.0, 6.0, 4.0), Level, settings);
  settings.metresPerUnit = 1e-3;
  const SensorGrid millimetres = GridOver(RectangleAt(0.0, 0.0, 6e3, 4e3), Level, settings);
  ASSERT_EQ(millimetres.sensors.size(), metres.sensors.size());
  for (std::size_t i = 0; i < metres.sensors.size(); ++i)
  {
    EXPECT_LT(
      glm::distance(millimetres.sensors[i].position, 1e3 * metres.sensors[i].position), 1e-6);
  }
}

TEST(SensorGrid, KeepsItsMarginInCornersThatLookInwards)
{
  // An L of two rectangles whose seam has other corners on either side.
  const std::vector<AreaTriangle> area =
    Together(RectangleAt(0.0, 0.0, 4.0, 8.0), RectangleAt(4.0, 0.0, 9.0, 3.0));
  GridSettings settings;
  settings.spacing = 0.25;
  const SensorGrid grid = GridOver(area, Level, settings);
  double nearSeam = 10.0, right = 0.0;
  for (const Sensor& sensor : grid.sensors)
  {
    const glm::dvec3& p = sensor.position;
    EXPECT_TRUE(p.x < 3.5001 || p.y < 3.0) << p.x << " " << p.y;
    EXPECT_TRUE(p.y < 2.5001 || p.x < 4.0) << p.x << " " << p.y;
    const double fromCorner = std::hypot(p.x - 4.0, p.y - 3.0);
    EXPECT_GE(fromCorner, 0.5 - 1e-9);
    nearSeam = p.y < 2.0 ? std::min(nearSeam, std::fabs(p.x - 4.0)) : nearSeam;
    right = std::max(right, p.x);
  }
  EXPECT_LT(nearSeam, 0.2); // a seam has no margin
  EXPECT_GT(right, 8.2);
}

TEST(SensorGrid, RunsAlongTheLongestEdge)
{
  const double angle = 0.5;
  const glm::dvec3 u(std::cos(angle), std::sin(angle), 0.0),
    v(-std::sin(angle), std::cos(angle), 0.0);
  const std::vector<AreaTriangle> area{ { glm::dvec3(0.0), 6.0 * u, 6.0 * u + 4.0 * v },
    { glm::dvec3(0.0), 6.0 * u + 4.0 * v, 4.0 * v } };
  const SensorGrid turned = GridOver(area, Level, {});
  const SensorGrid straight = GridOver(RectangleAt(0.0, 0.0, 6.0, 4.0), Level, {});
  EXPECT_EQ(turned.sensors.size(), straight.sensors.size());
  EXPECT_NEAR(turned.cellArea, straight.cellArea, 1e-9);
}

TEST(SensorGrid, TakesTheLowestOfLevelsAndNoSteepTriangle)
{
  std::vector<AreaTriangle> area =
    Together(RectangleAt(0.0, 0.0, 6.0, 4.0), RectangleAt(0.0, 0.0, 6.0, 4.0, 3.0));
  area.push_back({ glm::dvec3(0.0), { 6.0, 0.0, 0.0 }, { 0.0, 0.0, -3.0 } });
  for (const Sensor& sensor : GridOver(area, Level, {}).sensors)
  {
    EXPECT_NEAR(sensor.position.z, 0.75, 1e-12);
  }
}

TEST(SensorGrid, LiesOverTheBottomOfABoxWhicheverWayIsUp)
{
  const glm::dvec3 low(-1.0, -2.0, -3.0), high(4.0, 5.0, 6.0);
  const SensorDirections yUp = SensorDirections::From({ 0.0, 2.0, 0.0 }, 0.0);
  const SensorGrid grid = GridOver(BottomOfBox(low, high, yUp.up), yUp, {});
  for (const Sensor& sensor : grid.sensors)
  {
    EXPECT_NEAR(sensor.position.y, -1.25, 1e-12);
  }
  EXPECT_NEAR(grid.cellArea * static_cast<double>(grid.sensors.size()), 4.0 * 8.0, 1e-9);
}

TEST(SensorGrid, RefusesWhatMakesNoSense)
{
  const auto area = RectangleAt(0.0, 0.0, 6.0, 4.0);
  GridSettings settings;
  settings.margin = 2.0;
  EXPECT_NE(ErrorOf(area, settings).find("margin of 2 m leaves nothing"), std::string::npos);
  settings.margin = -1.0;
  EXPECT_NE(ErrorOf(area, settings).find("margin is -1 m"), std::string::npos);
  settings = {};
  settings.spacing = 1e-4;
  EXPECT_NE(ErrorOf(area, settings).find("1000000 are allowed"), std::string::npos);
  settings.spacing = std::nan("");
  EXPECT_NE(ErrorOf(area, settings).find("spacing"), std::string::npos);
  EXPECT_NE(ErrorOf({ { glm::dvec3(0.0), { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } } }, {})
              .find("no horizontal polygon"),
    std::string::npos);
}
