// SPDX-License-Identifier: BSD-3-Clause
#include "EffectScenes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <utility>

using namespace PhotonTransport;
using Shapes::Surface;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr glm::dvec3 LampPosition(-1.0, 0.5, 0.8);
constexpr double Lumens = 1000.0; // lm, of all lamps of a scene together

Material Matt(const Colour& reflectance)
{
  Material material;
  material.diffuseReflectance = reflectance;
  return material;
}

Material Mirror()
{
  Material material;
  material.specularReflectance = Colour(0.9f);
  return material;
}

Material Glossy()
{
  Material material = Matt(Colour(0.3f));
  material.glossyReflectance = Colour(0.5f);
  return material;
}

Material Shade()
{
  Material material = Matt(Colour(0.5f));
  material.diffuseTransmittance = Colour(0.4f);
  return material;
}

Material Glass(bool solid)
{
  Material material;
  material.clearTransmittance = Colour(0.95f);
  material.refractiveIndex = 1.5f;
  material.solid = solid;
  return material;
}

/// The material of each facet, by its number and its first corner.
using Choice = std::function<std::uint32_t(std::size_t, const glm::dvec3&)>;

Surface WithMaterials(Surface surface, std::vector<Material> materials, const Choice& choose)
{
  surface.materials = std::move(materials);
  surface.materialOfFacet.clear();
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    surface.materialOfFacet.push_back(choose(f, surface.points[surface.facets[f].x]));
  }
  return surface;
}

/// Whether a point belongs to the sphere of Shapes::RoomWithSphere.
bool OnBall(const glm::dvec3& point)
{
  return glm::distance(point, { 0.2, 0.1, -0.3 }) < 0.61;
}

Surface WithBall(Surface room, const Material& ball)
{
  return WithMaterials(std::move(room), { Matt(Colour(0.5f)), ball },
    [](std::size_t, const glm::dvec3& point) { return OnBall(point) ? 1u : 0u; });
}

Surface Coloured(Surface room)
{
  return WithMaterials(std::move(room), { Matt({ 0.7f, 0.45f, 0.3f }), Matt({ 0.3f, 0.5f, 0.7f }) },
    [](std::size_t, const glm::dvec3& point) { return OnBall(point) ? 1u : 0u; });
}

/// All that one facet calls for, all photons walk through.
Surface WithOneFacet(Surface room, const Material& material)
{
  return WithMaterials(std::move(room), { Matt(Colour(0.5f)), material },
    [](std::size_t facet, const glm::dvec3&) { return facet == 0 ? 1u : 0u; });
}

/// Coloured walls, the ball in bands of a mirror, glossy, a shade and a pane, and a second one,
/// small and of solid glass.
Surface WithEverything(Surface room)
{
  Surface second = Shapes::UvSphere(32, 16, Shapes::Facing::Outward);
  for (glm::dvec3& point : second.points)
  {
    point = 0.3 * point + glm::dvec3(-1.2, -0.7, -0.6);
  }
  const std::size_t first = room.facets.size();
  return WithMaterials(Shapes::Together(std::move(room), second),
    { Matt({ 0.7f, 0.45f, 0.3f }), Mirror(), Glossy(), Shade(), Glass(false), Glass(true) },
    [first](std::size_t facet, const glm::dvec3& point) -> std::uint32_t
    {
      const auto band = static_cast<std::uint32_t>(std::floor(8.0 * (point.z + 1.0))) % 4;
      return facet >= first ? 5 : (OnBall(point) ? 1 + band : 0);
    });
}

/// Without its ceiling.
Surface Opened(Surface room)
{
  std::vector<glm::uvec3> kept;
  for (const glm::uvec3& facet : room.facets)
  {
    if (room.normals[facet.x].z > -0.5 || OnBall(room.points[facet.x]))
    {
      kept.push_back(facet);
    }
  }
  room.facets = std::move(kept);
  return Shapes::WithReflectance(std::move(room), 0.5f);
}

/// Only the walls: the rings around all points are flat.
Surface BoxAlone(int triangles, bool tilted)
{
  const int cells = static_cast<int>(std::sqrt(triangles / 12.0));
  Surface box = Shapes::Box(
    glm::dvec3(-2.0, -1.5, -1.2), glm::dvec3(2.0, 1.5, 1.2), cells, Shapes::Facing::Inward);
  if (tilted)
  {
    box.normals[0] += glm::dvec3(0.0, 0.2, 0.0);
  }
  return Shapes::WithReflectance(std::move(box), 0.5f);
}

/// Light as even as a point lamp's, out of a table of 37 by 25 directions.
PhotometricLamp EvenPhotometricLamp()
{
  PhotometricLamp lamp;
  lamp.position = LampPosition;
  for (int i = 0; i <= 36; ++i)
  {
    lamp.solid.polar.push_back(5.0 * i);
  }
  for (int i = 0; i <= 24; ++i)
  {
    lamp.solid.azimuth.push_back(15.0 * i);
  }
  lamp.solid.candela.assign(37 * 25, Lumens / (4.0 * Pi));
  return lamp;
}

/// On two rows below the ceiling.
Lighting TenLamps(const Colour& colour)
{
  Lighting lighting;
  for (int i = 0; i < 10; ++i)
  {
    const glm::dvec3 place(-1.6 + 0.8 * (i / 2), i % 2 == 0 ? -0.8 : 0.8, 0.8);
    const double flux = Lumens / 10.0;
    lighting.luminaires.push_back({ PointLamp{ place, flux }, std::to_string(i), colour });
  }
  return lighting;
}

} // namespace

std::vector<EffectScene> EffectScenes(int triangles)
{
  const Surface room = Shapes::WithReflectance(Shapes::RoomWithSphere(triangles), 0.5f);
  const Surface open = Opened(room);
  const Material grey = Matt(Colour(0.5f));
  const Material red = Matt({ 0.6f, 0.5f, 0.4f });
  const Lighting point(PointLamp{ LampPosition, Lumens });
  Lighting warm = point;
  warm.luminaires[0].colour = { 1.0f, 0.8f, 0.6f };
  UniformSky sky;
  sky.luminance = Lumens / Pi;
  CieSky clear;
  clear.type = 12;
  TraceSettings apart;
  apart.lampsApart = true;
  const Lighting white = TenLamps(Colour(1.0f));
  return {
    { "diffuse", "diffuse", room, point, {} },
    { "direct light only", "diffuse", Shapes::WithReflectance(room, 0.0f), point, {} },
    { "table of grey materials", "diffuse", WithBall(room, grey), point, {} },
    { "coloured surfaces", "diffuse", Coloured(room), point, {} },
    { "coloured lamp", "diffuse", room, warm, {} },
    { "mirror ball", "diffuse", WithBall(room, Mirror()), point, {} },
    { "glossy ball", "diffuse", WithBall(room, Glossy()), point, {} },
    { "ball as a lamp shade", "diffuse", WithBall(room, Shade()), point, {} },
    { "ball of thin panes", "diffuse", WithBall(room, Glass(false)), point, {} },
    { "ball of solid glass", "diffuse", WithBall(room, Glass(true)), point, {} },
    { "one coloured triangle", "diffuse", WithOneFacet(room, red), point, {} },
    { "one mirror triangle", "diffuse", WithOneFacet(room, Mirror()), point, {} },
    { "one pane triangle", "diffuse", WithOneFacet(room, Glass(false)), point, {} },
    { "10 point lamps", "diffuse", room, white, {} },
    { "10 point lamps, kept apart", "10 point lamps", room, white, apart },
    { "photometric lamp", "diffuse", room, EvenPhotometricLamp(), {} },
    { "everything", "diffuse", WithEverything(room), TenLamps({ 1.0f, 0.8f, 0.6f }), apart },
    { "open room", "diffuse", open, point, {} },
    { "open room, even sky", "open room", open, sky, {} },
    { "open room, CIE clear sky", "open room", open, clear, {} },
    { "box, one tilted normal", "diffuse", BoxAlone(triangles, true), point, {} },
    { "box, all normals flat", "box, one tilted normal", BoxAlone(triangles, false), point, {} },
  };
}
