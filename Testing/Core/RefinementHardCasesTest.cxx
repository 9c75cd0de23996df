// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedMeshes.h"
#include "Shapes.h"

#include "PhotonTransport/refinement/Refinement.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace PhotonTransport;
using namespace RefinedMeshes;
using Shapes::Facing;

namespace
{

struct HardCase
{
  const char* name;
  Surface surface;
};

/// A square in cells, of which points lie on a crease from one border to the middle: there both
/// sides have points of their own.
Surface CreaseThatEndsInside()
{
  Surface grid = Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4);
  for (glm::dvec3& normal : grid.normals)
  {
    normal = { 0.2, 0.0, 1.0 };
  }
  const std::size_t points = grid.points.size();
  for (std::size_t p = 0; p < points; ++p)
  {
    if (grid.points[p].x == 0.5 && grid.points[p].y < 0.4)
    {
      const auto copy = static_cast<unsigned>(grid.points.size());
      grid.points.push_back(glm::dvec3(grid.points[p]));
      grid.normals.emplace_back(-0.8, 0.3, 1.0);
      for (glm::uvec3& facet : grid.facets)
      {
        const double middle =
          (grid.points[facet.x].x + grid.points[facet.y].x + grid.points[facet.z].x) / 3.0;
        for (int corner = 0; corner < 3 && middle > 0.5; ++corner)
        {
          facet[corner] = facet[corner] == p ? copy : facet[corner];
        }
      }
    }
  }
  return grid;
}

/// A third facet on an edge of a sphere.
Surface WithFin(Surface sphere)
{
  const glm::uvec3 facet = sphere.facets[5];
  sphere.points.push_back(1.5 * (sphere.points[facet.x] + sphere.points[facet.y]));
  sphere.normals.push_back(sphere.normals[facet.z]);
  sphere.facets.emplace_back(facet.x, facet.y, static_cast<unsigned>(sphere.points.size() - 1));
  return sphere;
}

/// Facets of one part that a mirror turned over: they wind against their normals.
Surface WithMirrorImage(const Surface& body)
{
  Surface image = body;
  for (std::size_t p = 0; p < image.points.size(); ++p)
  {
    image.points[p].x = 2.8 - image.points[p].x; // they touch at x = 1.4
    image.normals[p].x = -image.normals[p].x;
  }
  return Shapes::Together(body, image);
}

Surface WithTurnedNormals(Surface surface, double degrees)
{
  const double angle = glm::radians(degrees);
  for (std::size_t p = 0; p < surface.normals.size(); p += 2)
  {
    const glm::dvec3 n = surface.normals[p];
    const glm::dvec3 across = glm::normalize(glm::cross(n, glm::dvec3(0.31, 0.52, 0.17)));
    surface.normals[p] = std::cos(angle) * n + std::sin(angle) * across;
  }
  return surface;
}

} // namespace

TEST(CurvedRefinement, HardCasesStayAsClosedAsTheyWere)
{
  Surface contrary = Shapes::Icosphere(2, Facing::Outward);
  for (std::size_t p = 0; p < contrary.normals.size(); p += 3)
  {
    contrary.normals[p] *= p % 2 == 0 ? -1.0 : 0.0;
  }
  const HardCase cases[] = { { "needles", Shapes::UvSphere(400, 3, Facing::Outward) },
    { "zero and contrary normals", contrary },
    { "a crease that ends inside", CreaseThatEndsInside() },
    { "three facets on an edge", WithFin(Shapes::Icosphere(1, Facing::Outward)) },
    { "normals 170 degrees off", WithTurnedNormals(Shapes::Torus(16, 8, Facing::Outward), 170.0) },
    { "normals 80 degrees off", WithTurnedNormals(Shapes::Icosphere(2, Facing::Outward), 80.0) },
    { "a mirror image", WithMirrorImage(Shapes::Torus(24, 8, Facing::Outward)) },
    { "noise", WithTurnedNormals(CappedCylinder(7, 0.2), 35.0) } };
  for (const HardCase& hard : cases)
  {
    const RefinedMesh mesh = Refined(hard.surface);
    EXPECT_EQ(Gaps(hard.surface, mesh), 0u) << hard.name;
    EXPECT_EQ(TurnedParts(hard.surface, mesh), 0u) << hard.name;
    for (const glm::dvec3& p : mesh.points)
    {
      EXPECT_TRUE(std::isfinite(p.x + p.y + p.z)) << hard.name;
    }
  }
}

// One facet of which an edge lies beside a hundred others.
TEST(CurvedRefinement, OneFacetBesideManyStaysClosed)
{
  Surface surface = Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 100);
  const auto first = static_cast<unsigned>(surface.points.size());
  surface.points.insert(surface.points.end(), { { 0, 0, 0 }, { 0.5, -1, 0 }, { 1, 0, 0 } });
  surface.normals.insert(surface.normals.end(), { { -0.3, 0, 1 }, { 0, -0.3, 1 }, { 0.3, 0, 1 } });
  surface.facets.emplace_back(first, first + 1, first + 2);
  const RefinedMesh mesh = Refined(surface);
  for (const glm::dvec3& p : mesh.points)
  {
    EXPECT_TRUE(p.y != 0.0 || p.z == 0.0) << "the edge beside many stays straight";
  }
  EXPECT_GT(mesh.facets.size(), surface.facets.size());
}
