// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedMeshes.h"
#include "Shapes.h"

#include "PhotonTransport/refinement/Refinement.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

using namespace PhotonTransport;
using namespace RefinedMeshes;
using Shapes::Facing;

TEST(CurvedRefinement, LeavesFlatFacetsWhole)
{
  const Surface box = Shapes::Box({ 0, 0, 0 }, { 4, 3, 2 }, 3, Facing::Outward);
  const Refinement refinement(MeshOf(box), Fine);
  EXPECT_TRUE(refinement.IsTrivial());
  const RefinedMesh mesh = refinement.Make();
  EXPECT_EQ(mesh.facets, box.facets);
  EXPECT_EQ(mesh.points, box.points);
}

TEST(CurvedRefinement, KeepsTheGivenPointsFirst)
{
  const Surface sphere = Shapes::UvSphere(16, 8, Facing::Outward);
  const RefinedMesh mesh = Refined(sphere);
  ASSERT_GT(mesh.points.size(), sphere.points.size());
  EXPECT_TRUE(std::equal(sphere.points.begin(), sphere.points.end(), mesh.points.begin()));
}

// The middle of an arc is exact; elsewhere a parabola stands for it, whose error is of the fourth
// order in half the angle x of an edge: 1/2 x^4 t^2 (1-t^2) / 4 or less of the radius.
TEST(CurvedRefinement, PointsLieOnTheSphere)
{
  for (const Facing facing : { Facing::Outward, Facing::Inward })
  {
    const RefinedMesh mesh = Refined(Shapes::UvSphere(16, 8, facing));
    const double x = glm::pi<double>() / 16.0;
    for (const glm::dvec3& p : mesh.points)
    {
      EXPECT_NEAR(glm::length(p), 1.0, 2.0 * x * x * x * x);
    }
    EXPECT_EQ(OpenEdges(mesh), 0u);
  }
}

// Each facet keeps its share of the parent, and each part is in its place on the patch.
TEST(CurvedRefinement, PartsFillTheirFacets)
{
  const Surface torus = Shapes::Torus(24, 8, Facing::Outward);
  const RefinedMesh mesh = Refined(torus);
  std::vector<double> share(torus.facets.size(), 0.0);
  for (const FacetOrigin& origin : mesh.origins)
  {
    share[origin.facet] += std::fabs(glm::dot(glm::dvec3(origin.corners[0]),
      glm::cross(glm::dvec3(origin.corners[1]), glm::dvec3(origin.corners[2]))));
  }
  EXPECT_EQ(share, std::vector<double>(torus.facets.size(), 1.0)); // exact, as coordinates are
  EXPECT_EQ(TurnedParts(torus, mesh), 0u);
  EXPECT_EQ(OpenEdges(mesh), 0u);
}

// What halving all parts adds to the volume falls to a quarter, until the patches are reached,
// whose volume is wrong by the fourth power of half the angle of an edge.
TEST(CurvedRefinement, ConvergesToThePatches)
{
  const Surface sphere = Shapes::UvSphere(16, 8, Facing::Outward);
  std::vector<double> volumes;
  for (const double degrees : { 6.0, 3.0, 1.5, 0.75 })
  {
    RefinementLimits limits;
    limits.turn = glm::radians(degrees);
    volumes.push_back(Volume(Refined(sphere, limits)));
  }
  for (std::size_t i = 2; i < volumes.size(); ++i)
  {
    EXPECT_NEAR((volumes[i - 1] - volumes[i - 2]) / (volumes[i] - volumes[i - 1]), 4.0, 0.1);
  }
  const double exact = 4.0 / 3.0 * glm::pi<double>(), x = glm::pi<double>() / 16.0;
  EXPECT_NEAR(volumes.back(), exact, 3.0 * x * x * x * x * exact / 4.0);
}

// A round rim becomes round, and closed, although each of its surfaces has points of its own.
TEST(CurvedRefinement, ACappedCylinderIsClosedAndRound)
{
  for (const int around : { 8, 12, 16 })
  {
    const Surface cylinder = CappedCylinder(around, 2.0);
    ASSERT_EQ(OpenEdges(cylinder.points, cylinder.facets), 0u);
    const RefinedMesh mesh = Refined(cylinder);
    EXPECT_EQ(OpenEdges(mesh), 0u);
    const double exact = 2.0 * glm::pi<double>();
    EXPECT_NEAR(Volume(mesh), exact, 0.004 * exact); // an angle of 7 degrees: 2/3 (x/2)^2 = 0.25 %
    for (const glm::dvec3& p : mesh.points)
    {
      EXPECT_GE(p.z, -1e-9);
      EXPECT_LE(p.z, 2.0 + 1e-9);
    }
  }
}

// Noise in the normals: edges become straight where a part would turn its back, on both sides.
TEST(CurvedRefinement, StaysClosedWithAnyNormals)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (const double size : { 0.1, 0.5, 2.0 })
  {
    for (Surface surface :
      { Shapes::Icosphere(2, Facing::Outward), Shapes::Torus(12, 6, Facing::Inward),
        Shapes::Box({ 0, 0, 0 }, { 1, 2, 3 }, 2, Facing::Outward), CappedCylinder(9, 0.01) })
    {
      for (glm::dvec3& normal : surface.normals)
      {
        normal += size * glm::dvec3(noise(random), noise(random), noise(random));
      }
      surface.normals[3] = glm::dvec3(0.0);
      surface.normals[5] *= -1.0;
      const RefinedMesh mesh = Refined(surface);
      EXPECT_EQ(OpenEdges(mesh), 0u);
      EXPECT_EQ(TurnedParts(surface, mesh), 0u);
    }
  }
}

// One facet beside two: what curves on one side only would open a gap.
TEST(CurvedRefinement, EdgesWithAPointOnThemStayStraight)
{
  Surface surface;
  surface.points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { -1, -1, 0 },
    { 1, -1, 0 } };
  surface.facets = { { 0, 1, 2 }, { 0, 4, 3 }, { 3, 5, 1 }, { 3, 4, 5 } };
  surface.normals.assign(6, glm::dvec3(0, 0, 1));
  surface.normals[0] = { -0.3, 0, 1 };
  surface.normals[1] = { 0.3, 0, 1 };
  surface.normals[3] = { 0.1, 0, 1 };
  const RefinedMesh mesh = Refined(surface);
  EXPECT_GT(mesh.facets.size(), surface.facets.size());
  for (const glm::dvec3& p : mesh.points)
  {
    EXPECT_TRUE(p.y != 0.0 || p.z == 0.0) << p.x;
  }
}

TEST(CurvedRefinement, EdgesKeepToTheLengthAndTheSagitta)
{
  const Surface floor = Shapes::Rectangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 }, 1);
  RefinementLimits limits;
  limits.length = 0.3;
  const RefinedMesh mesh = Refined(floor, limits);
  double area = 0.0;
  for (const glm::uvec3& f : mesh.facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_LE(glm::distance(mesh.points[f[i]], mesh.points[f[(i + 1) % 3]]), 0.3);
    }
    area += glm::length(AreaVector(mesh.points, f));
  }
  EXPECT_NEAR(area, 12.0, 1e-9);

  limits = {};
  limits.sagitta = 0.001;
  const RefinedMesh sphere = Refined(Shapes::Icosphere(2, Facing::Outward), limits);
  for (const glm::uvec3& f : sphere.facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      // The curve of a sphere rises over its chord by the chord's distance from the sphere.
      const glm::dvec3 middle = 0.5 * (sphere.points[f[i]] + sphere.points[f[(i + 1) % 3]]);
      EXPECT_LT(1.0 - glm::length(middle), 0.0013);
    }
  }
}

TEST(CurvedRefinement, FitsANumberOfFacets)
{
  const Surface sphere = Shapes::Icosphere(2, Facing::Outward);
  Refinement refinement(MeshOf(sphere), Fine);
  const std::uint64_t all = refinement.NumberOfFacets();
  ASSERT_GT(all, 2000u);
  const RefinementLimits& wider = refinement.Fit(2000);
  EXPECT_GT(wider.turn, Fine.turn);
  EXPECT_LE(refinement.NumberOfFacets(), 2000u);
  EXPECT_EQ(OpenEdges(refinement.Make()), 0u);
  refinement.Fit(0);
  EXPECT_TRUE(refinement.IsTrivial());
}

TEST(CurvedRefinement, HasTheSameBitsForAnyNumberOfThreads)
{
  const Surface surface = Shapes::Torus(48, 40, Facing::Outward);
  RefinedMesh meshes[2];
  for (const int threads : { 1, 2 })
  {
    tbb::task_arena(threads).execute([&] { meshes[threads - 1] = Refined(surface); });
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
  EXPECT_EQ(meshes[0].facets, meshes[1].facets);
}

// A wall that is drawn once for each side stays one wall: the same triangles, turned.
TEST(CurvedRefinement, SheetsThatFaceOppositeWaysHaveTheSameParts)
{
  const Surface out = Shapes::Torus(16, 9, Facing::Outward);
  Surface in = out;
  for (std::size_t f = 0; f < in.facets.size(); ++f)
  {
    const glm::uvec3 ids = in.facets[f];
    const int turn = static_cast<int>(f % 3);
    in.facets[f] = { ids[turn], ids[(turn + 2) % 3], ids[(turn + 1) % 3] };
  }
  for (glm::dvec3& normal : in.normals)
  {
    normal = -normal;
  }
  const RefinedMesh both = Refined(Shapes::Together(out, in));
  const std::size_t half = both.facets.size() / 2;
  std::map<std::array<Place, 3>, int> triangles;
  for (std::size_t f = 0; f < both.facets.size(); ++f)
  {
    std::array<Place, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& p = both.points[both.facets[f][i]];
      corners[static_cast<std::size_t>(i)] = { p.x, p.y, p.z };
    }
    std::sort(corners.begin(), corners.end());
    triangles[corners] += f < half ? 1 : -1;
  }
  EXPECT_EQ(triangles.size(), half);
  for (const auto& [corners, sum] : triangles)
  {
    EXPECT_EQ(sum, 0);
  }
}

// Parts that were made apart meet at points that differ by rounding: no more gap opens there than
// there was.
TEST(CurvedRefinement, BordersThatDifferByRoundingCurveAlike)
{
  Surface cylinder = CappedCylinder(12, 2.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (glm::dvec3& point : cylinder.points)
  {
    point += 0x1p-24 * glm::dvec3(unit(random), unit(random), unit(random));
  }
  const TriangleMesh mesh{ cylinder.points, cylinder.normals, cylinder.facets, 0x1p-24 };
  const RefinedMesh fine = Refinement(mesh, Fine).Make();
  EXPECT_NEAR(Volume(fine), 2.0 * glm::pi<double>(), 0.004 * 2.0 * glm::pi<double>());
  // Snapped to a lattice between whose points none of the mesh lies, it is closed.
  std::vector<glm::dvec3> snapped;
  for (const glm::dvec3& p : fine.points)
  {
    constexpr double Lattice = 0x1p-14;
    snapped.push_back(Lattice * glm::round(p / Lattice + 0.25));
  }
  EXPECT_LE(OpenEdges(snapped, fine.facets), 0u);
}
