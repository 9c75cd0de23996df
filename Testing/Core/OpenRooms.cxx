// SPDX-License-Identifier: BSD-3-Clause
#include "OpenRooms.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace OpenRooms
{
namespace
{

/// The coordinates at which a wall is divided.
std::vector<double> Lines(double length, const std::vector<double>& edges)
{
  std::vector<double> lines{ 0.0, length };
  lines.insert(lines.end(), edges.begin(), edges.end());
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

} // namespace

Surface Wall(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
  const glm::dvec2& lengths, const std::vector<Edges>& holes)
{
  std::vector<double> atU, atV;
  for (const Edges& hole : holes)
  {
    atU.insert(atU.end(), { hole.u0, hole.u1 });
    atV.insert(atV.end(), { hole.v0, hole.v1 });
  }
  const std::vector<double> us = Lines(lengths.x, atU), vs = Lines(lengths.y, atV);
  Surface wall;
  for (const double y : vs)
  {
    for (const double x : us)
    {
      wall.points.push_back(corner + x * u + y * v);
    }
  }
  const auto point = [&](std::size_t i, std::size_t j)
  { return static_cast<unsigned>(j * us.size() + i); };
  for (std::size_t j = 0; j + 1 < vs.size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
    {
      const double x = 0.5 * (us[i] + us[i + 1]), y = 0.5 * (vs[j] + vs[j + 1]);
      if (std::none_of(holes.begin(), holes.end(),
            [&](const Edges& hole)
            { return x > hole.u0 && x < hole.u1 && y > hole.v0 && y < hole.v1; }))
      {
        wall.facets.push_back({ point(i, j), point(i + 1, j), point(i + 1, j + 1) });
        wall.facets.push_back({ point(i, j), point(i + 1, j + 1), point(i, j + 1) });
      }
    }
  }
  wall.normals.assign(wall.points.size(), glm::cross(u, v));
  wall.materials.resize(1);
  wall.materialOfFacet.assign(wall.facets.size(), 0);
  return wall;
}

using Shapes::Together;

Surface Room(const std::vector<Edges>& holes)
{
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Surface room = Wall({ 4, 0, 0 }, y, z, { 4, 3 }, holes);
  room = Together(room, Wall({ 0, 0, 0 }, y, z, { 4, 3 }));
  room = Together(room, Wall({ 0, 0, 0 }, x, z, { 4, 3 }));
  room = Together(room, Wall({ 0, 4, 0 }, x, z, { 4, 3 }));
  room = Together(room, Wall({ 0, 0, 0 }, x, y, { 4, 4 }));
  return Together(room, Wall({ 0, 0, 3 }, x, y, { 4, 4 }));
}

Surface Ground(double height, bool whole)
{
  const Edges floor{ 18, 18, 22, 22 };
  return Wall({ -18, -18, height }, { 1, 0, 0 }, { 0, 1, 0 }, { 40, 40 },
    whole ? std::vector<Edges>{} : std::vector{ floor });
}

Surface WithPointsApart(Surface surface)
{
  const Surface given = surface;
  surface.points.clear();
  surface.normals.clear();
  for (glm::uvec3& facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      surface.normals.push_back(given.normals[facet[corner]]);
      surface.points.push_back(given.points[facet[corner]]);
      facet[corner] = static_cast<unsigned>(surface.points.size() - 1);
    }
  }
  return surface;
}

Surface Moved(Surface surface, double scale, const glm::dvec3& shift, bool toSingle)
{
  for (glm::dvec3& point : surface.points)
  {
    point = scale * point + shift;
    point = toSingle ? glm::dvec3(glm::vec3(point)) : point;
  }
  surface.rounding = toSingle ? 0x1p-24 : 0.0;
  return surface;
}

Surface WithMaterial(Surface surface, const PhotonTransport::Material& material)
{
  surface.materials.push_back(material);
  surface.materialOfFacet.assign(
    surface.facets.size(), static_cast<std::uint32_t>(surface.materials.size() - 1));
  return surface;
}

PhotonTransport::Material ClearMaterial()
{
  PhotonTransport::Material material;
  material.clearTransmittance = PhotonTransport::Colour(1.0f);
  return material;
}

} // namespace OpenRooms
