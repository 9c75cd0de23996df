// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <glm/vec2.hpp>

namespace Shapes
{

namespace
{

/// A rectangle from corner along unit u and v, as long as `lengths`, around an opening.
Surface RectangleAround(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
  const glm::dvec2& lengths, const Edges& opening)
{
  Surface all;
  const auto add = [&](double u0, double u1, double v0, double v1)
  {
    if (u1 > u0 && v1 > v0)
    {
      const Surface part = Rectangle(corner + u0 * u + v0 * v, (u1 - u0) * u, (v1 - v0) * v, 1);
      all = all.points.empty() ? part : Together(all, part);
    }
  };
  add(0.0, lengths.x, 0.0, opening.v0);
  add(0.0, lengths.x, opening.v1, lengths.y);
  add(0.0, opening.u0, opening.v0, opening.v1);
  add(opening.u1, lengths.x, opening.v0, opening.v1);
  return all;
}

/// The room's floor and those of its sides that have no opening.
Surface ClosedSides(double side, double height, int cells, bool wall, bool roof)
{
  const double h = 0.5 * side;
  Surface room = Rectangle({ -h, -h, 0 }, { side, 0, 0 }, { 0, side, 0 }, cells);
  room = Together(room, Rectangle({ -h, -h, 0 }, { 0, side, 0 }, { 0, 0, height }, 1)); // x = -h
  room = Together(room, Rectangle({ h, -h, 0 }, { 0, 0, height }, { 0, side, 0 }, 1));
  room = Together(room, Rectangle({ -h, -h, 0 }, { 0, 0, height }, { side, 0, 0 }, 1)); // y = -h
  if (wall)
  {
    room = Together(room, Rectangle({ -h, h, 0 }, { side, 0, 0 }, { 0, 0, height }, 1));
  }
  if (roof)
  {
    room = Together(room, Rectangle({ -h, -h, height }, { 0, side, 0 }, { side, 0, 0 }, 1));
  }
  return room;
}

} // namespace

Surface OpenRoom(double side, double height, const Edges& opening, int cells)
{
  const double h = 0.5 * side;
  const Surface room = ClosedSides(side, height, cells, true, false);
  const Surface roof = RectangleAround({ -h, -h, height }, { 1, 0, 0 }, { 0, 1, 0 }, { side, side },
    { opening.u0 + h, opening.v0 + h, opening.u1 + h, opening.v1 + h });
  return roof.points.empty() ? room : Together(room, roof);
}

Surface RoomWithWindow(double side, double height, const Edges& opening, int cells)
{
  const double h = 0.5 * side;
  return Together(ClosedSides(side, height, cells, false, true),
    RectangleAround({ -h, h, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { side, height },
      { opening.u0 + h, opening.v0, opening.u1 + h, opening.v1 }));
}

} // namespace Shapes
