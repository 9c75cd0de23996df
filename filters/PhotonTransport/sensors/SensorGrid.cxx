// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sensors/SensorGrid.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace PhotonTransport
{
namespace
{

[[noreturn]] void Refuse(const std::string& message)
{
  throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message);
}

std::vector<AreaTriangle> HorizontalOnes(
  const std::vector<AreaTriangle>& triangles, const glm::dvec3& up)
{
  constexpr double Level = 0.99619469809; // the cosine of 5 degrees
  std::vector<AreaTriangle> horizontal;
  for (const AreaTriangle& t : triangles)
  {
    const glm::dvec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double length = glm::length(across);
    if (length > 0.0 && std::fabs(glm::dot(across, up)) >= Level * length)
    {
      horizontal.push_back(t);
    }
  }
  if (horizontal.empty())
  {
    Refuse("there is no horizontal polygon to put a grid over");
  }
  return horizontal;
}

/// With its first axis along the longest edge.
GridPlan PlanAlong(const std::vector<GridEdge>& outline, const GridPlan& plan)
{
  double longest = 0.0;
  GridPlan along = plan;
  for (const GridEdge& edge : outline)
  {
    const glm::dvec2 way(edge.to - edge.from);
    const double length = glm::length(way);
    if (length > longest * (1.0 + 1e-9))
    {
      longest = length;
      along.u = (way.x * plan.u + way.y * plan.v) / length;
      along.v = glm::cross(plan.up, along.u);
    }
  }
  return along;
}

void Validate(const GridSettings& settings)
{
  const auto require = [](bool holds, const char* name, double value, const char* range)
  {
    if (!holds)
    {
      std::ostringstream message;
      message << "the grid's " << name << " is " << value << " m; it must be " << range;
      Refuse(message.str());
    }
  };
  require(std::isfinite(settings.height), "height", settings.height, "finite");
  require(settings.margin >= 0.0 && std::isfinite(settings.margin), "margin", settings.margin,
    "0 or more, and finite");
  require(settings.spacing >= 0.0 && std::isfinite(settings.spacing), "spacing", settings.spacing,
    "0 (by EN 12464-1) or more, and finite");
}

/// Refuses a margin that leaves nothing of the rectangle, m.
void RequireRoom(const glm::dvec2& rectangle, double margin)
{
  const glm::dvec2 inner = rectangle - 2.0 * margin;
  if (!(inner.x > 0.0) || !(inner.y > 0.0))
  {
    std::ostringstream message;
    message << "the grid's margin of " << margin << " m leaves nothing of an area of "
            << rectangle.x << " m by " << rectangle.y << " m";
    Refuse(message.str());
  }
}

} // namespace

double GridSpacing(double length, double width)
{
  const double longer = std::max(length, width);
  const double shorter = std::min(length, width);
  const double d = longer >= 2.0 * shorter ? shorter : longer;
  constexpr double Most = 10.0;
  return std::min(Most, 0.2 * std::pow(5.0, std::log10(d)));
}

std::array<std::size_t, 2> GridCells(double length, double width, double spacing)
{
  const double sides[2] = { length, width };
  const bool byStandard = !(spacing > 0.0);
  const double wanted = byStandard ? GridSpacing(length, width) : spacing;
  const bool isLong = std::max(length, width) >= 2.0 * std::min(length, width);
  // Along the side that d is.
  const int first = (length >= width) == !isLong ? 0 : 1;
  const double number = std::max(1.0, std::round(sides[first] / wanted));
  const double other = std::max(1.0, std::round(sides[1 - first] / (sides[first] / number)));
  if (!(number * other <= static_cast<double>(GridSettings::MostSensors)))
  {
    std::ostringstream message;
    message << "a grid of " << wanted << " m has " << number * other << " points; "
            << GridSettings::MostSensors << " are allowed";
    Refuse(message.str());
  }
  std::array<std::size_t, 2> cells;
  cells[first] = static_cast<std::size_t>(number);
  cells[1 - first] = static_cast<std::size_t>(other);
  return cells;
}

std::vector<AreaTriangle> BottomOfBox(
  const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& up)
{
  const SensorDirections level = SensorDirections::From(up, 0.0);
  const GridPlan plan{ level.views[0], level.views[1], level.up };
  glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 p = plan.ToPlan({ (corner & 1) != 0 ? high.x : low.x,
      (corner & 2) != 0 ? high.y : low.y, (corner & 4) != 0 ? high.z : low.z });
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const auto corner = [&](double x, double y) { return plan.FromPlan({ x, y, least.z }); };
  const glm::dvec3 a = corner(least.x, least.y), b = corner(most.x, least.y),
                   c = corner(most.x, most.y), d = corner(least.x, most.y);
  return { { a, b, c }, { a, c, d } };
}

SensorGrid GridOver(const std::vector<AreaTriangle>& area, const SensorDirections& directions,
  const GridSettings& settings)
{
  Validate(settings);
  const double perMetre = 1.0 / settings.metresPerUnit;
  const std::vector<AreaTriangle> horizontal = HorizontalOnes(area, directions.up);
  const SensorDirections level = SensorDirections::From(directions.up, 0.0);
  const GridPlan straight{ level.views[0], level.views[1], directions.up };
  const GridPlan plan = PlanAlong(GridArea(horizontal, straight).Outline(), straight);
  const GridArea flat(horizontal, plan);
  const std::vector<GridEdge> outline = flat.Outline();
  const glm::dvec2 rectangle = glm::dvec2(flat.High - flat.Low) * settings.metresPerUnit;
  RequireRoom(rectangle, settings.margin);
  const glm::dvec2 inner = rectangle - 2.0 * settings.margin;
  SensorGrid grid;
  grid.cells = GridCells(inner.x, inner.y, settings.spacing);
  const glm::dvec2 cell = inner / glm::dvec2(grid.cells[0], grid.cells[1]);
  grid.cellArea = cell.x * cell.y;
  const double margin = settings.margin * perMetre * (1.0 - 1e-9); // for rounding
  for (std::size_t row = 0; row < grid.cells[1]; ++row)
  {
    for (std::size_t column = 0; column < grid.cells[0]; ++column)
    {
      const glm::dvec2 inCells(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      const glm::dvec2 place = (settings.margin + inCells * cell) * perMetre;
      glm::dvec3 point(flat.Low.x + place.x, flat.Low.y + place.y, 0.0);
      const std::optional<double> height = flat.HeightAt(point);
      if (height &&
        std::all_of(outline.begin(), outline.end(),
          [&](const GridEdge& edge) { return DistanceTo(edge, point) >= margin; }))
      {
        point.z = *height + settings.height * perMetre;
        grid.sensors.push_back({ plan.FromPlan(point), directions.up });
        grid.cellOf.push_back({ column, row });
      }
    }
  }
  if (grid.sensors.empty())
  {
    std::ostringstream message;
    message << "the grid's margin of " << settings.margin << " m leaves nothing of the area";
    Refuse(message.str());
  }
  return grid;
}

} // namespace PhotonTransport
