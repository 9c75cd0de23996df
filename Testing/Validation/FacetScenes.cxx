// SPDX-License-Identifier: BSD-3-Clause
#include "FacetScenes.h"

#include "Shapes.h"

#include <cmath>
#include <ostream>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

Surface Moved(Surface surface, double size, const glm::dvec3& centre)
{
  for (glm::dvec3& point : surface.points)
  {
    point = size * point + centre;
  }
  return surface;
}

Surface Room(int cells, float reflectance)
{
  return Shapes::WithReflectance(
    Shapes::Box({ 0, 0, 0 }, { 4, 4, 3 }, cells, Facing::Inward), reflectance);
}

FacetScene Cube(int cells)
{
  const Surface box = Shapes::Box(glm::dvec3(-2), glm::dvec3(2), cells, Facing::Inward);
  const auto squares = static_cast<std::uint64_t>(cells) * static_cast<std::uint64_t>(cells);
  return { "Cube" + std::to_string(cells), Shapes::WithReflectance(box, 2.0f / 3.0f),
    PointLamp{ glm::dvec3(0), 10'000.0 }, 5000 * squares, 256 };
}

/// Boxes stand on the floor, which goes on below them: contact shadows.
FacetScene RoomWithBoxes(const std::string& name, const Lamp& lamp)
{
  Surface all = Room(24, 0.5f);
  all = Shapes::Together(all,
    Shapes::WithReflectance(
      Shapes::Box({ 0.77, 1.13, 0 }, { 1.59, 1.88, 0.8 }, 6, Facing::Outward), 0.5f));
  all = Shapes::Together(all,
    Shapes::WithReflectance(
      Shapes::Box({ 2.37, 2.21, 0 }, { 3.08, 2.93, 1.4 }, 6, Facing::Outward), 0.5f));
  return { name, all, lamp, 2'000'000, 1024 };
}

FacetScene RoomWithSphere()
{
  const Surface sphere = Shapes::WithReflectance(Shapes::Icosphere(2, Facing::Outward), 0.5f);
  return { "RoomAndSphere", Shapes::Together(Room(24, 0.6f), Moved(sphere, 0.6, { 1.5, 1.8, 1.0 })),
    RectangleLamp{ { 2.0, 2.0, 2.95 }, { 0, 0, -1 }, 0.6, 0.6, 3000.0, { 1, 0, 0 } }, 2'000'000,
    400 };
}

FacetScene SunOnSphereAndFloor()
{
  const Surface floor = Shapes::Rectangle({ -3, -3, -1 }, { 6, 0, 0 }, { 0, 6, 0 }, 20);
  return { "SunOnSphereAndFloor",
    Shapes::WithReflectance(Shapes::Together(floor, Shapes::Icosphere(2, Facing::Outward)), 0.4f),
    ParallelLight{ glm::dvec3(0.3, 0.2, -1.0) }, 200'000, 64 };
}

/// Not among the scenes by which the factors were chosen.
FacetScene TorusOverWaves()
{
  Surface floor = Shapes::Rectangle({ -3, -3, -0.6 }, { 6, 0, 0 }, { 0, 6, 0 }, 40);
  for (std::size_t p = 0; p < floor.points.size(); ++p)
  {
    glm::dvec3& point = floor.points[p];
    const double x = 2.1 * point.x;
    const double y = 1.7 * point.y;
    point.z += 0.25 * std::sin(x) * std::cos(y);
    floor.normals[p] = glm::dvec3(
      -0.25 * 2.1 * std::cos(x) * std::cos(y), 0.25 * 1.7 * std::sin(x) * std::sin(y), 1.0);
  }
  return { "TorusOverWaves",
    Shapes::WithReflectance(
      Shapes::Together(
        floor, Moved(Shapes::Torus(40, 20, Facing::Outward), 0.8, { 0.2, 0.1, 0.7 })),
      0.7f),
    DiskLamp{ { -0.8, 0.6, 2.3 }, { 0, 0, -1 }, 0.1, 2000.0 }, 2'000'000, 400 };
}

} // namespace

std::ostream& operator<<(std::ostream& os, const FacetScene& scene)
{
  return os << scene.name;
}

std::vector<FacetScene> FacetScenes()
{
  return { Cube(10), Cube(20), RoomWithSphere(),
    RoomWithBoxes("SoftShadows",
      RectangleLamp{ { 2.1, 1.8, 2.9 }, { 0, 0, -1 }, 0.8, 0.8, 3000.0, { 1, 0, 0 } }),
    RoomWithBoxes("HardShadows", PointLamp{ { 2.1, 1.8, 2.7 }, 3000.0 }),
    FacetScene{
      "LampNearWall", Room(24, 0.5f), PointLamp{ { 0.3, 1.97, 1.53 }, 1000.0 }, 1'000'000, 400 },
    SunOnSphereAndFloor(), TorusOverWaves() };
}
