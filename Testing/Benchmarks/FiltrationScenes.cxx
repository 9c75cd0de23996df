// SPDX-License-Identifier: BSD-3-Clause
#include "FiltrationScenes.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;
using Shapes::Surface;

namespace
{

Surface Placed(Surface surface, double size, const glm::dvec3& centre)
{
  for (glm::dvec3& point : surface.points)
  {
    point = size * point + centre;
  }
  return surface;
}

Surface RoomWithFineSphere(int cells, float reflectance)
{
  const Surface room = Shapes::Box({ -2.0, -1.5, -1.2 }, { 2.0, 1.5, 1.2 }, cells, Facing::Inward);
  const Surface sphere = Placed(Shapes::Octasphere(6, Facing::Outward), 0.6, { 0.2, 0.1, -0.3 });
  return Shapes::WithReflectance(Shapes::Together(room, sphere), reflectance);
}

Surface BoxesOnFloor()
{
  Surface all = Shapes::Rectangle({ -3.0, -3.0, 0.0 }, { 6.0, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, 120);
  struct Crate
  {
    double x, y, halfWidth, height;
  };
  for (const Crate& crate : { Crate{ -1.5, -1.2, 0.35, 0.8 }, Crate{ 1.3, -0.9, 0.3, 1.5 },
         Crate{ 0.2, 1.4, 0.4, 0.5 }, Crate{ -1.7, 1.6, 0.25, 1.1 } })
  {
    const glm::dvec3 low(crate.x - crate.halfWidth, crate.y - crate.halfWidth, 0.0);
    const glm::dvec3 high(crate.x + crate.halfWidth, crate.y + crate.halfWidth, crate.height);
    all = Shapes::Together(all, Shapes::Box(low, high, 22, Facing::Outward));
  }
  const Surface room = Shapes::Box({ -3.0, -3.0, -0.001 }, { 3.0, 3.0, 3.0 }, 16, Facing::Inward);
  return Shapes::WithReflectance(Shapes::Together(all, room), 0.5f);
}

Surface TorusOverWaves()
{
  Surface floor =
    Shapes::Rectangle({ -3.0, -3.0, -0.6 }, { 6.0, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, 130);
  for (std::size_t p = 0; p < floor.points.size(); ++p)
  {
    glm::dvec3& point = floor.points[p];
    const double x = 2.1 * point.x;
    const double y = 1.7 * point.y;
    point.z += 0.25 * std::sin(x) * std::cos(y);
    floor.normals[p] = glm::normalize(glm::dvec3(
      -0.25 * 2.1 * std::cos(x) * std::cos(y), 0.25 * 1.7 * std::sin(x) * std::sin(y), 1.0));
  }
  const Surface torus = Placed(Shapes::Torus(160, 80, Facing::Outward), 0.8, { 0.2, 0.1, 0.7 });
  return Shapes::WithReflectance(Shapes::Together(floor, torus), 0.7f);
}

} // namespace

std::vector<FiltrationScene> FiltrationScenes()
{
  const glm::dvec3 down(0.0, 0.0, -1.0);
  return {
    { "A", "smooth light from a cove", RoomWithFineSphere(56, 0.6f),
      RectangleLamp{ { 0.0, -0.7, 0.4 }, -down, 3.0, 0.5, 1000.0 } },
    { "B", "hard shadow of a sphere", RoomWithFineSphere(63, 0.5f),
      DiskLamp{ { -0.5, -0.3, 1.15 }, down, 0.03, 1000.0 } },
    { "C", "boxes in penumbrae", BoxesOnFloor(),
      RectangleLamp{ { 0.0, 0.0, 2.9 }, down, 0.8, 0.8, 3000.0 } },
    { "D", "coarse mesh", Shapes::WithReflectance(Shapes::RoomWithSphere(830), 0.5f),
      PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 } },
    { "E", "torus over waves, not tuned on", TorusOverWaves(),
      SpotLamp{ { 1.5, -1.5, 4.0 }, { -0.3, 0.35, -1.0 }, 0.7, 2.0, 3000.0 } },
  };
}
