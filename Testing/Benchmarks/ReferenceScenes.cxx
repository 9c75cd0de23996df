// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceScenes.h"

#include "MeshFile.h"
#include "ReferenceNumbers.h"
#include "Shapes.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr int Cells = 24; // of a side of the rooms
constexpr float FloorReflectance = 0.3f, WallReflectance = 0.6f, CeilingReflectance = 0.8f;

Material Matt(float reflectance)
{
  Material material;
  material.diffuseReflectance = Colour(reflectance);
  return material;
}

std::vector<std::uint32_t> Vertices(std::size_t first, std::size_t last)
{
  std::vector<std::uint32_t> vertices(last - first);
  std::iota(vertices.begin(), vertices.end(), static_cast<std::uint32_t>(first));
  return vertices;
}

ReferenceScene RoomWithPanelAndSphere()
{
  Surface room = Shapes::Box({ 0, 0, 0 }, { 4, 4, 3 }, Cells, Facing::Inward);
  for (std::size_t side = 0; side < room.materials.size(); ++side)
  {
    room.materials[side] = Matt(WallReflectance);
  }
  room.materials[0] = Matt(FloorReflectance); // as Box orders its sides
  room.materials[1] = Matt(CeilingReflectance);
  Surface sphere = Shapes::WithReflectance(Shapes::Icosphere(5, Facing::Outward), 0.5f);
  for (glm::dvec3& point : sphere.points)
  {
    point = 0.6 * point + glm::dvec3(1.5, 1.8, 1.0);
  }
  ReferenceScene scene;
  scene.points = Vertices(room.points.size(), room.points.size() + sphere.points.size());
  scene.surface = Shapes::Together(std::move(room), sphere);
  scene.lighting = RectangleLamp{ { 2.0, 2.0, 2.95 }, { 0, 0, -1 }, 0.6, 0.6, 3000.0, { 1, 0, 0 } };
  scene.target = 0.003;
  return scene;
}

/// Leaves out the facets with their centroid in a box, and then all points that no facet has.
Surface WithHole(const Surface& surface, const glm::dvec3& low, const glm::dvec3& high)
{
  Surface kept = surface;
  kept.points.clear();
  kept.normals.clear();
  kept.facets.clear();
  std::vector<std::uint32_t> place(surface.points.size(), NoFacet);
  for (const glm::uvec3& facet : surface.facets)
  {
    const glm::dvec3 middle =
      (surface.points[facet.x] + surface.points[facet.y] + surface.points[facet.z]) / 3.0;
    if (!(glm::all(glm::greaterThan(middle, low)) && glm::all(glm::lessThan(middle, high))))
    {
      kept.facets.push_back(facet);
    }
  }
  for (glm::uvec3& facet : kept.facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      std::uint32_t& id = place[facet[k]];
      if (id == NoFacet)
      {
        id = static_cast<std::uint32_t>(kept.points.size());
        kept.points.push_back(surface.points[facet[k]]);
        kept.normals.push_back(surface.normals[facet[k]]);
      }
      facet[k] = id;
    }
  }
  kept.materialOfFacet.assign(kept.facets.size(), 0);
  return kept;
}

ReferenceScene RoomInDaylight()
{
  const auto side = [](const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                      float reflectance, int cells)
  { return Shapes::WithReflectance(Shapes::Rectangle(corner, u, v, cells), reflectance); };
  const glm::dvec3 x(4, 0, 0), y(0, 4, 0), z(0, 0, 3);
  Surface all = side({ 0, -2, 0 }, x, y, FloorReflectance, Cells);
  all = Shapes::Together(all, side({ 0, -2, 0 }, y, z, WallReflectance, Cells));
  all = Shapes::Together(all, side({ 0, -2, 0 }, z, x, WallReflectance, Cells));
  all = Shapes::Together(all, side({ 0, 2, 0 }, x, z, WallReflectance, Cells));
  // The window is 8 of 24 cells wide and 12 high, 4/3 by 1.5 m.
  const glm::dvec3 low(3.0, -2.0 / 3.0, 0.75), high(5.0, 2.0 / 3.0, 2.25);
  all =
    Shapes::Together(all, WithHole(side({ 4, -2, 0 }, z, y, WallReflectance, Cells), low, high));
  ReferenceScene scene;
  scene.points = Vertices(0, all.points.size());
  all = Shapes::Together(all, side({ 0, -2, 3 }, y, x, CeilingReflectance, Cells));
  all = Shapes::Together(all, side({ 4, -20, 0 }, { 40, 0, 0 }, { 0, 40, 0 }, 0.2f, 40));
  scene.surface = all;
  CieSky sky;
  sky.type = 16;
  scene.lighting = sky;
  scene.guides = { { { 4.0, 0.0, 1.5 }, { 0, 2.0 / 3.0, 0 }, { 0, 0, 0.75 }, { -1, 0, 0 } } };
  scene.target = 0.005;
  return scene;
}

/// A cube [-2, 2]^3. An eighth of the face z = -2 is all there is to know of it.
ReferenceScene Cube(int cells, float reflectance, double target)
{
  ReferenceScene scene;
  scene.surface = Shapes::WithReflectance(
    Shapes::Box(glm::dvec3(-2), glm::dvec3(2), cells, Facing::Inward), reflectance);
  scene.lighting = PointLamp{ glm::dvec3(0.0), 10'000.0 };
  constexpr double Rounding = 1e-9;
  for (std::uint32_t v = 0; v < static_cast<std::uint32_t>((cells + 1) * (cells + 1)); ++v)
  {
    const glm::dvec3& p = scene.surface.points[v];
    if (p.x > -Rounding && p.y > -Rounding && p.y < p.x + Rounding)
    {
      scene.points.push_back(v);
    }
  }
  scene.target = target;
  return scene;
}

ReferenceScene Cabin(const std::string& folder)
{
  ReferenceScene scene;
  scene.surface = ReadPlainMesh(folder + "/cabin.mesh");
  scene.lighting = EmittingFacets();
  // Most of the light comes from the ceiling, which the coves light.
  scene.guides = { { { 2.4, 0.0, 1.98 }, { 2.4, 0, 0 }, { 0, 1.02, 0 }, { 0, 0, -1 } } };
  scene.points = Vertices(0, scene.surface.points.size());
  ReferenceNumbers random(1);
  for (std::size_t i = scene.points.size(); i > 1; --i)
  {
    std::swap(scene.points[i - 1], scene.points[random.Bits() % i]);
  }
  scene.lit = 2000;
  return scene;
}

} // namespace

std::vector<std::string> ReferenceSceneNames()
{
  return { "cie171", "cube10", "cube20", "cube40", "room", "daylight", "cabin" };
}

ReferenceScene MakeReferenceScene(const std::string& name, const std::string& folder)
{
  constexpr float CubeReflectance = 2.0f / 3.0f;
  if (name == "cie171")
  {
    return Cube(20, 0.5f, 0.0002);
  }
  if (name == "cube10" || name == "cube20" || name == "cube40")
  {
    return Cube(std::stoi(name.substr(4)), CubeReflectance, 0.001);
  }
  if (name == "room")
  {
    return RoomWithPanelAndSphere();
  }
  if (name == "daylight")
  {
    return RoomInDaylight();
  }
  if (name == "cabin")
  {
    return Cabin(folder);
  }
  throw std::runtime_error("no scene " + name);
}
