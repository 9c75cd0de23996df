// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace Shapes
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;

struct PointAndNormal
{
  glm::dvec3 point;
  glm::dvec3 normal;
};

void FinishFacets(Surface& surface)
{
  surface.materials.resize(1); // black
  surface.materialOfFacet.assign(surface.facets.size(), 0);
}

Surface Faced(Surface surface, Facing facing)
{
  if (facing == Facing::Inward)
  {
    for (glm::dvec3& normal : surface.normals)
    {
      normal = -normal;
    }
    for (glm::uvec3& facet : surface.facets)
    {
      std::swap(facet.y, facet.z);
    }
  }
  return surface;
}

/// Grid of a parametrised patch: m x n squares, (m + 1) x (n + 1) vertices; closed directions share
/// their seam's vertices. Squares that degenerate to triangles (poles) yield one.
struct Grid
{
  int m, n;
  bool closedU = false;
  bool closedV = false;
};

Surface Patch(const Grid& grid, const std::function<PointAndNormal(double, double)>& at)
{
  const int columns = grid.closedU ? grid.m : grid.m + 1;
  const int rows = grid.closedV ? grid.n : grid.n + 1;
  Surface surface;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const PointAndNormal p = at(double(i) / grid.m, double(j) / grid.n);
      surface.points.push_back(p.point);
      surface.normals.push_back(p.normal);
    }
  }
  const auto id = [&](int i, int j)
  { return static_cast<unsigned>((j % rows) * columns + i % columns); };
  for (int j = 0; j < grid.n; ++j)
  {
    for (int i = 0; i < grid.m; ++i)
    {
      surface.facets.emplace_back(id(i, j), id(i + 1, j), id(i + 1, j + 1));
      surface.facets.emplace_back(id(i, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  FinishFacets(surface);
  return surface;
}

/// Merges the vertices of one row into one (a pole) and drops the facets that vanish.
void MergeRow(Surface& surface, unsigned first, unsigned count)
{
  std::vector<glm::uvec3> kept;
  for (glm::uvec3 facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (facet[corner] >= first && facet[corner] < first + count)
      {
        facet[corner] = first;
      }
    }
    if (facet.x != facet.y && facet.y != facet.z && facet.z != facet.x)
    {
      kept.push_back(facet);
    }
  }
  surface.facets = std::move(kept);
  FinishFacets(surface);
}

/// Splits every facet in four and puts all vertices onto the unit sphere.
void Subdivide(Surface& sphere)
{
  std::map<std::pair<unsigned, unsigned>, unsigned> middles;
  const auto middle = [&](unsigned a, unsigned b)
  {
    const auto [entry, fresh] =
      middles.emplace(std::minmax(a, b), static_cast<unsigned>(sphere.points.size()));
    if (fresh)
    {
      sphere.points.push_back(glm::normalize(sphere.points[a] + sphere.points[b]));
    }
    return entry->second;
  };
  std::vector<glm::uvec3> facets;
  for (const glm::uvec3& f : sphere.facets)
  {
    const unsigned a = middle(f.x, f.y);
    const unsigned b = middle(f.y, f.z);
    const unsigned c = middle(f.z, f.x);
    facets.insert(facets.end(), { { f.x, a, c }, { a, f.y, b }, { c, b, f.z }, { a, b, c } });
  }
  sphere.facets = std::move(facets);
}

Surface SubdividedSphere(Surface start, int levels, Facing facing)
{
  for (glm::dvec3& point : start.points)
  {
    point = glm::normalize(point);
  }
  for (int level = 0; level < levels; ++level)
  {
    Subdivide(start);
  }
  start.normals = start.points;
  FinishFacets(start);
  return Faced(std::move(start), facing);
}

PointAndNormal OnSphere(double azimuth, double polar)
{
  const glm::dvec3 p(
    std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
  return { p, p };
}

} // namespace

Surface Octasphere(int levels, Facing facing)
{
  Surface start;
  start.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  start.facets = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  return SubdividedSphere(std::move(start), levels, facing);
}

Surface Icosphere(int levels, Facing facing)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Surface start;
  start.points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },
    { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 },
    { -g, 0, 1 } };
  start.facets = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
    { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
    { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  return SubdividedSphere(std::move(start), levels, facing);
}

Surface UvSphere(int around, int along, Facing facing)
{
  Surface sphere = Patch({ around, along, true, false },
    [](double u, double v) { return OnSphere(2.0 * Pi * u, Pi * (1.0 - v)); });
  const auto row = static_cast<unsigned>(around);
  MergeRow(sphere, 0, row);
  MergeRow(sphere, row * static_cast<unsigned>(along), row);
  return Faced(std::move(sphere), facing);
}

Surface Torus(int around, int across, Facing facing)
{
  constexpr double Tube = 0.4;
  return Faced(Patch({ around, across, true, true },
                 [](double u, double v)
                 {
                   const double a = 2.0 * Pi * u;
                   const double b = 2.0 * Pi * v;
                   const glm::dvec3 normal(
                     std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
                   const glm::dvec3 ring(std::cos(a), std::sin(a), 0.0);
                   return PointAndNormal{ ring + Tube * normal, normal };
                 }),
    facing);
}

Surface Tube(int around, int along, Facing facing)
{
  return Faced(Patch({ around, along, true, false },
                 [](double u, double v)
                 {
                   const glm::dvec3 normal(std::cos(2.0 * Pi * u), std::sin(2.0 * Pi * u), 0.0);
                   return PointAndNormal{ normal + glm::dvec3(0.0, 0.0, 2.0 * v - 1.0), normal };
                 }),
    facing);
}

Surface Cap(int around, int along, double degrees)
{
  Surface cap = Patch({ around, along, true, false },
    [=](double u, double v) { return OnSphere(2.0 * Pi * u, degrees * Degree * (1.0 - v)); });
  MergeRow(cap, static_cast<unsigned>(around * along), static_cast<unsigned>(around));
  return cap;
}

Surface Rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int cells)
{
  const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
  return Patch({ cells, cells },
    [=](double s, double t) {
      return PointAndNormal{ corner + s * u + t * v, normal };
    });
}

Surface Disk(double radius, double z, int around, int along, bool up)
{
  const glm::dvec3 normal(0.0, 0.0, up ? 1.0 : -1.0);
  Surface disk = Patch({ around, along, true, false },
    [=](double u, double v)
    {
      const double r = radius * (1.0 - v);
      return PointAndNormal{ { r * std::cos(2.0 * Pi * u), r * std::sin(2.0 * Pi * u), z },
        normal };
    });
  MergeRow(disk, static_cast<unsigned>(around * along), static_cast<unsigned>(around));
  return disk;
}

Surface Box(const glm::dvec3& low, const glm::dvec3& high, int cells, Facing facing)
{
  const glm::dvec3 d = high - low;
  const glm::dvec3 x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
  Surface box = Rectangle(low, y, x, cells);
  box = Together(std::move(box), Rectangle(low + z, x, y, cells));
  box = Together(std::move(box), Rectangle(low, x, z, cells));
  box = Together(std::move(box), Rectangle(low + y, z, x, cells));
  box = Together(std::move(box), Rectangle(low, z, y, cells));
  box = Together(std::move(box), Rectangle(low + x, y, z, cells));
  return Faced(std::move(box), facing);
}

Surface Wedge(double degrees, Facing facing)
{
  // The acute edge is the z axis; each face has its own vertices.
  const glm::dvec3 a(0.0), b(1.0, 0.0, 0.0);
  const glm::dvec3 c(std::cos(degrees * Degree), std::sin(degrees * Degree), 0.0), up(0, 0, 1);
  Surface wedge = Rectangle(a, b, up, 1);
  wedge = Together(std::move(wedge), Rectangle(b, c - b, up, 1));
  wedge = Together(std::move(wedge), Rectangle(c, a - c, up, 1));
  Surface ends;
  ends.points = { a, c, b, a + up, b + up, c + up };
  ends.normals = { -up, -up, -up, up, up, up };
  ends.facets = { { 0, 1, 2 }, { 3, 4, 5 } };
  FinishFacets(ends);
  return Faced(Together(std::move(wedge), ends), facing);
}

Surface RoomWithSphere(int triangles)
{
  const int along = static_cast<int>(std::sqrt(triangles / 8.0));
  Surface ball = UvSphere(2 * along, along, Facing::Outward);
  for (glm::dvec3& point : ball.points)
  {
    point = 0.6 * point + glm::dvec3(0.2, 0.1, -0.3);
  }
  const int cells = static_cast<int>(std::sqrt(triangles / 24.0));
  return Together(
    Box(glm::dvec3(-2.0, -1.5, -1.2), glm::dvec3(2.0, 1.5, 1.2), cells, Facing::Inward), ball);
}

Surface Together(Surface a, const Surface& b)
{
  const auto offset = static_cast<unsigned>(a.points.size());
  const bool emits = !a.exitance.empty() || !b.exitance.empty();
  if (emits)
  {
    a.exitance.resize(a.facets.size(), PhotonTransport::Colour(0.0f));
    a.exitance.insert(a.exitance.end(), b.exitance.begin(), b.exitance.end());
    a.exitance.resize(a.facets.size() + b.facets.size(), PhotonTransport::Colour(0.0f));
  }
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  const auto firstMaterial = static_cast<std::uint32_t>(a.materials.size());
  a.materials.insert(a.materials.end(), b.materials.begin(), b.materials.end());
  for (const std::uint32_t material : b.materialOfFacet)
  {
    a.materialOfFacet.push_back(firstMaterial + material);
  }
  for (const glm::uvec3& facet : b.facets)
  {
    a.facets.push_back(facet + offset);
  }
  return a;
}

Surface WithReflectance(Surface surface, float reflectance)
{
  PhotonTransport::Material material;
  material.diffuseReflectance = PhotonTransport::Colour(reflectance);
  surface.materials = { material };
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  return surface;
}

Surface WithExitance(Surface surface, float exitance)
{
  surface.exitance.assign(surface.facets.size(), PhotonTransport::Colour(exitance));
  return surface;
}

} // namespace Shapes
