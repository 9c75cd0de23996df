// SPDX-License-Identifier: BSD-3-Clause
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
#include <tuple>
#include <utility>

using namespace PhotonTransport;
using Shapes::Facing;
using Shapes::Surface;

namespace
{

/// The limits by which tracing refines: parts of an arc turn by 7 degrees at most.
const RefinementLimits Fine{ RefinementLimits::None, RefinementLimits::None, glm::radians(7.0) };

TriangleMesh MeshOf(const Surface& surface)
{
  return { surface.points, surface.normals, surface.facets };
}

RefinedMesh Refined(const Surface& surface, const RefinementLimits& limits = Fine)
{
  return Refinement(MeshOf(surface), limits).Make();
}

using Place = std::tuple<double, double, double>;

/// How many edges, as pieces of space, do not have as many facets that run along them one way as
/// the other way. A closed mesh has none.
std::size_t OpenEdges(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  std::map<std::pair<Place, Place>, int> edges;
  for (const glm::uvec3& facet : facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 &p = points[facet[i]], &q = points[facet[(i + 1) % 3]];
      const Place a{ p.x, p.y, p.z }, b{ q.x, q.y, q.z };
      edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

std::size_t OpenEdges(const RefinedMesh& mesh)
{
  return OpenEdges(mesh.points, mesh.facets);
}

double Volume(const RefinedMesh& mesh)
{
  double sixVolumes = 0.0;
  for (const glm::uvec3& f : mesh.facets)
  {
    sixVolumes += glm::dot(mesh.points[f.x], glm::cross(mesh.points[f.y], mesh.points[f.z]));
  }
  return sixVolumes / 6.0;
}

glm::dvec3 AreaVector(const std::vector<glm::dvec3>& points, const glm::uvec3& f)
{
  return 0.5 * glm::cross(points[f.y] - points[f.x], points[f.z] - points[f.x]);
}

std::size_t TurnedParts(const Surface& surface, const RefinedMesh& mesh)
{
  std::size_t turned = 0;
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const glm::dvec3 part = AreaVector(mesh.points, mesh.facets[f]);
    const glm::dvec3 whole = AreaVector(surface.points, surface.facets[mesh.origins[f].facet]);
    turned += !(glm::dot(part, whole) > 0.0);
  }
  return turned;
}

/// Each surface has points of its own at the rims, as VTK's filters make them.
Surface CappedCylinder(int around, double height)
{
  Surface surface;
  surface.materials.resize(1);
  const auto add = [&](const glm::dvec3& point, const glm::dvec3& normal)
  {
    surface.points.push_back(point);
    surface.normals.push_back(normal);
    return static_cast<unsigned>(surface.points.size() - 1);
  };
  const auto rim = [&](int i, double z)
  {
    const double angle = 2.0 * glm::pi<double>() * (i % around) / around;
    return glm::dvec3(std::cos(angle), std::sin(angle), z);
  };
  const unsigned bottom = add({ 0, 0, 0 }, { 0, 0, -1 }), top = add({ 0, 0, height }, { 0, 0, 1 });
  for (int i = 0; i < around; ++i)
  {
    const glm::dvec3 down(0, 0, -1), up(0, 0, 1);
    const glm::dvec3 out0 = rim(i, 0), out1 = rim(i + 1, 0);
    const unsigned a = add(rim(i, 0), out0), b = add(rim(i + 1, 0), out1);
    const unsigned c = add(rim(i, height), out0), d = add(rim(i + 1, height), out1);
    surface.facets.insert(surface.facets.end(), { { a, b, d }, { a, d, c } });
    surface.facets.emplace_back(bottom, add(rim(i + 1, 0), down), add(rim(i, 0), down));
    surface.facets.emplace_back(top, add(rim(i, height), up), add(rim(i + 1, height), up));
  }
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  return surface;
}

} // namespace

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

/// In how many places facets of a refined mesh meet otherwise than the facets they are parts of:
/// along an edge as many run each way as along the edge it is a part of, and along one inside a
/// facet one each way.
std::size_t Gaps(const Surface& surface, const RefinedMesh& mesh)
{
  const auto key = [](const glm::dvec3& p, const glm::dvec3& q)
  {
    const Place a{ p.x, p.y, p.z }, b{ q.x, q.y, q.z };
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto way = [](const glm::dvec3& p, const glm::dvec3& q) {
    return Place{ p.x, p.y, p.z } < Place{ q.x, q.y, q.z } ? 1 : -1;
  };
  std::map<std::pair<Place, Place>, int> coarse, fine;
  std::map<std::pair<Place, Place>, std::pair<Place, Place>> partOf;
  for (const glm::uvec3& f : surface.facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 &p = surface.points[f[i]], &q = surface.points[f[(i + 1) % 3]];
      coarse[key(p, q)] += way(p, q);
    }
  }
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const glm::uvec3& whole = surface.facets[mesh.origins[f].facet];
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const glm::dvec3 &p = mesh.points[mesh.facets[f][i]], &q = mesh.points[mesh.facets[f][next]];
      const glm::vec3& b = mesh.origins[f].corners[static_cast<std::size_t>(i)];
      const glm::vec3& c = mesh.origins[f].corners[static_cast<std::size_t>(next)];
      int direction = way(p, q);
      for (int side = 0; side < 3; ++side)
      {
        if (b[side] == 0.0f && c[side] == 0.0f)
        {
          const glm::dvec3& from = surface.points[whole[(side + 1) % 3]];
          const glm::dvec3& to = surface.points[whole[(side + 2) % 3]];
          partOf[key(p, q)] = key(from, to);
          direction = way(from, to);
        }
      }
      fine[key(p, q)] += direction;
    }
  }
  return static_cast<std::size_t>(std::count_if(fine.begin(), fine.end(),
    [&](const auto& edge)
    {
      const auto whole = partOf.find(edge.first);
      return edge.second != (whole == partOf.end() ? 0 : coarse[whole->second]);
    }));
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
