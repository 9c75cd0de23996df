// SPDX-License-Identifier: BSD-3-Clause
#include "OpenRooms.h"

#include "Illumination/map/OpeningLines.h"

#include "PhotonTransport/openings/FindOpenings.h"
#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace PhotonTransport;
using namespace OpenRooms;
using Shapes::Facing;
using Shapes::Together;

namespace
{

/// An opening as it ought to be found, in the data's unit.
struct Expected
{
  double area;
  glm::dvec3 centre; ///< Of its bounding box.
  glm::dvec3 inwards;
  OpeningKind kind = OpeningKind::Hole;
};

FoundOpenings Find(const Surface& surface)
{
  return FindOpenings(surface, Scene(surface));
}

/// Exactly these openings are found, from the largest to the smallest.
void ExpectFound(const Surface& surface, const std::vector<Expected>& expected, double scale = 1.0)
{
  const Scene scene(surface);
  const std::vector<Opening> found = FindOpenings(surface, scene).openings.List();
  ASSERT_EQ(found.size(), expected.size());
  const Placement& placement = scene.GetPlacement();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    // In single precision 1 km away corners are up to 2^-14 m off, in the scene much less. Areas
    // change by as much times their perimeter, of less than 8 m where this matters.
    const double rounding = 0x1p-14 * scale;
    EXPECT_NEAR(found[i].Area() / (placement.scale * placement.scale),
      scale * scale * expected[i].area, 8.0 * rounding * scale);
    const glm::dvec3 centre = glm::dvec3(found[i].centre) / placement.scale + placement.centre;
    EXPECT_LT(glm::distance(centre, expected[i].centre), 2.0 * rounding);
    EXPECT_GT(glm::dot(glm::dvec3(found[i].normal), expected[i].inwards), 0.999);
    EXPECT_EQ(found[i].kind, expected[i].kind);
    for (const Opening::Triangle& t : found[i].triangles)
    {
      EXPECT_GT(glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), found[i].normal), 0.0f);
    }
  }
}

const Expected InWindow{ 1.33 * 1.5, { 4, 2, 1.65 }, { -1, 0, 0 } };

/// A pane in the window of the room, with corners that the wall shares.
Surface PaneIn(const Edges& hole, double x = 4.0)
{
  return WithMaterial(Wall({ x, hole.u0, hole.v0 }, { 0, 1, 0 }, { 0, 0, 1 },
                        { hole.u1 - hole.u0, hole.v1 - hole.v0 }),
    ClearMaterial());
}

/// Marks the last facets.
Surface Marked(Surface surface, std::size_t last, OpeningMark mark)
{
  surface.openingOfFacet.assign(surface.facets.size(), OpeningMark::None);
  std::fill(surface.openingOfFacet.end() - static_cast<std::ptrdiff_t>(last),
    surface.openingOfFacet.end(), mark);
  return surface;
}

/// The unit sphere without the facets above a height.
Surface SphereWithHole(double height)
{
  Surface sphere = Shapes::Icosphere(4, Facing::Inward);
  std::vector<glm::uvec3> kept;
  for (const glm::uvec3& facet : sphere.facets)
  {
    const double middle =
      (sphere.points[facet.x].z + sphere.points[facet.y].z + sphere.points[facet.z].z) / 3.0;
    if (middle < height)
    {
      kept.push_back(facet);
    }
  }
  sphere.facets = kept;
  sphere.materialOfFacet.assign(kept.size(), 0);
  return sphere;
}

} // namespace

TEST(Openings, AreTheWindowOfTheDaylightRoom)
{
  ExpectFound(Room({ Window }), { InWindow });
  // Ground that ends at the walls' feet, in the floor's plane, whole, and below the floor.
  ExpectFound(Together(Room({ Window }), Ground(0.0, false)), { InWindow });
  ExpectFound(Together(Room({ Window }), Ground(0.0, true)), { InWindow });
  ExpectFound(Together(Room({ Window }), Ground(-0.1, true)), { InWindow });
}

TEST(Openings, OfRoomsWhoseFacetsDoNotShareCorners)
{
  const Edges roof{ -0.5, -1.0, 1.0, 0.5 };
  ExpectFound(
    Shapes::OpenRoom(4.0, 3.0, roof, 7), { { 2.25, { 0.25, -0.25, 3.0 }, { 0, 0, -1 } } });
  ExpectFound(
    Shapes::OpenRoom(4.0, 3.0, { -2, -2, 2, 2 }, 7), { { 16.0, { 0, 0, 3 }, { 0, 0, -1 } } });
  ExpectFound(
    Shapes::OpenRoom(4.0, 3.0, { -2, -1, 0, 2 }, 7), { { 6.0, { -1, 0.5, 3 }, { 0, 0, -1 } } });
  const Edges window{ -1.0, 1.0, 0.5, 2.5 };
  ExpectFound(
    Shapes::RoomWithWindow(4.0, 3.0, window, 5), { { 2.25, { -0.25, 2.0, 1.75 }, { 0, -1, 0 } } });
  ExpectFound(WithPointsApart(Room({ Window })), { InWindow });
}

TEST(Openings, AreTwoWindowsAndADoor)
{
  const Edges door{ 0.2, 0.0, 1.1, 2.1 }, small{ 1.5, 1.0, 2.0, 2.0 }, wide{ 2.4, 1.0, 3.8, 2.2 };
  const std::vector<Expected> expected{ { 0.9 * 2.1, { 4, 0.65, 1.05 }, { -1, 0, 0 } },
    { 1.4 * 1.2, { 4, 3.1, 1.6 }, { -1, 0, 0 } }, { 0.5, { 4, 1.75, 1.5 }, { -1, 0, 0 } } };
  const Surface room = Room({ door, small, wide });
  ExpectFound(room, expected);
  // The threshold now is an edge of floor and ground, or the ground has no edge there at all.
  ExpectFound(Together(room, Ground(0.0, false)), expected);
  ExpectFound(Together(room, Ground(0.0, true)), expected);
  Surface withoutFloor = Together(Room({ door, small, wide }), Ground(0.0, true));
  const auto isFloor = [&](const glm::uvec3& f)
  {
    const glm::dvec3 middle =
      (withoutFloor.points[f.x] + withoutFloor.points[f.y] + withoutFloor.points[f.z]) / 3.0;
    return middle.z == 0.0 && middle.x > 0.0 && middle.x < 4.0 && middle.y > 0.0 &&
      middle.y < 4.0 && glm::distance(withoutFloor.points[f.x], withoutFloor.points[f.y]) < 10.0;
  };
  withoutFloor.facets.erase(
    std::remove_if(withoutFloor.facets.begin(), withoutFloor.facets.end(), isFloor),
    withoutFloor.facets.end());
  withoutFloor.materialOfFacet.assign(withoutFloor.facets.size(), 0);
  ExpectFound(withoutFloor, expected);
}

TEST(Openings, TouchEachOther)
{
  const Edges left{ 0.5, 0.5, 1.5, 1.5 }, right{ 1.5, 1.5, 2.5, 2.75 };
  ExpectFound(Room({ left, right }),
    { { 1.25, { 4, 2, 2.125 }, { -1, 0, 0 } }, { 1.0, { 4, 1, 1 }, { -1, 0, 0 } } });
}

TEST(Openings, HaveCornersThatTurnInwards)
{
  // An L: two rectangles with a side in common.
  const Edges upright{ 1.0, 0.5, 1.75, 2.5 }, foot{ 1.75, 0.5, 3.0, 1.0 };
  ExpectFound(Room({ upright, foot }), { { 1.5 + 0.625, { 4, 2, 1.5 }, { -1, 0, 0 } } });
}

TEST(Openings, OfASphereWithAHole)
{
  // The rim of an icosphere without its cap runs in zigzag, which is no flat loop.
  for (const double height : { 0.97, 0.5, 0.0 })
  {
    EXPECT_TRUE(Find(SphereWithHole(height)).openings.IsEmpty());
  }
  Surface uv = Shapes::UvSphere(48, 24, Facing::Inward);
  const double lowest = std::cos(glm::radians(30.0));
  const auto isCap = [&](const glm::uvec3& f) {
    return std::min({ uv.points[f.x].z, uv.points[f.y].z, uv.points[f.z].z }) > lowest - 1e-6;
  };
  uv.facets.erase(std::remove_if(uv.facets.begin(), uv.facets.end(), isCap), uv.facets.end());
  uv.materialOfFacet.assign(uv.facets.size(), 0);
  const double radius = 0.5; // of a polygon of 48 corners
  const double area = 24.0 * radius * radius * std::sin(glm::radians(7.5));
  ExpectFound(uv, { { area, { 0, 0, lowest }, { 0, 0, -1 } } });
}

TEST(Openings, AreNone)
{
  ExpectFound(Shapes::Box({ 0, 0, 0 }, { 4, 4, 3 }, 3, Facing::Inward), {});
  ExpectFound(Room({}), {});
  ExpectFound(Ground(0.0, true), {});
  ExpectFound(Ground(0.0, false), {});
  ExpectFound(Together(Room({}), Ground(0.0, true)), {});
  ExpectFound(Together(Room({}), Ground(0.0, false)), {});
  ExpectFound(Shapes::Icosphere(3, Facing::Outward), {});
  // A window in a wall that stands alone leads from outdoors to outdoors.
  const Surface wall = Wall({ 4, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 4, 3 }, { Window });
  ExpectFound(wall, {});
  EXPECT_EQ(Find(wall).notes.openToBothSides, 1u);
  // One inside of a closed box leads from indoors to indoors.
  const Surface inside =
    Together(Room({ Window }), Shapes::Box({ -5, -5, -5 }, { 9, 9, 9 }, 1, Facing::Inward));
  ExpectFound(inside, {});
  EXPECT_EQ(Find(inside).notes.withoutSky, 1u);
  // A board lies in the hole and does not share its corners.
  const Edges board{ Window.u0 - 0.01, Window.v0 - 0.01, Window.u1 + 0.01, Window.v1 + 0.01 };
  Surface closed = Together(Room({ Window }),
    Wall({ 4, board.u0, board.v0 }, { 0, 1, 0 }, { 0, 0, 1 },
      { board.u1 - board.u0, board.v1 - board.v0 }));
  ExpectFound(closed, {});
  EXPECT_EQ(Find(closed).notes.covered, 1u);
}

TEST(Openings, ArePanes)
{
  Expected pane = InWindow;
  pane.kind = OpeningKind::Glass;
  const Surface glazed = Together(Room({ Window }), PaneIn(Window));
  ExpectFound(glazed, { pane });
  // Behind the hole, its edges free: the hole is larger, or first.
  const Surface behind = Together(Room({ Window }),
    PaneIn({ Window.u0 + 0.1, Window.v0 + 0.1, Window.u1 - 0.1, Window.v1 - 0.1 }, 3.9));
  ExpectFound(behind, { InWindow });
  EXPECT_EQ(Find(behind).notes.doubled, 1u);
  ExpectFound(Marked(behind, 2, OpeningMark::NoOpening), {});
  // Both sheets of a pane, with other diagonals, and panes of a double window.
  Surface back = PaneIn(Window);
  back.facets = { { 0, 1, 2 }, { 1, 3, 2 } };
  ExpectFound(Together(glazed, back), { pane });
  ExpectFound(Together(glazed, PaneIn(Window, 3.95)), { pane });
  // Light that enters goes out by another pane.
  Surface solid = glazed;
  solid.materials.back().solid = true;
  solid.materials.back().refractiveIndex = 1.5f;
  ExpectFound(solid, {});
  const Surface free = PaneIn(Window);
  ExpectFound(free, {});
}

// A dome of glass over a closed cylinder has far more flat panes than are used: polygons cover it.
TEST(Openings, OfACurvedPaneCoverIt)
{
  const Surface wall = WithMaterial(Shapes::Tube(64, 1, Facing::Inward), Material());
  Surface room = Together(wall, Shapes::Disk(1.0, -1.0, 64, 1, true));
  Surface dome = Shapes::UvSphere(64, 32, Facing::Inward);
  const auto isLow = [&](const glm::uvec3& f) {
    return std::min({ dome.points[f.x].z, dome.points[f.y].z, dome.points[f.z].z }) < -1e-9;
  };
  dome.facets.erase(
    std::remove_if(dome.facets.begin(), dome.facets.end(), isLow), dome.facets.end());
  for (glm::dvec3& point : dome.points)
  {
    point.z = 0.2 * point.z + 1.0;
  }
  room = Together(room, WithMaterial(dome, ClearMaterial()));
  const Scene scene(room);
  const FoundOpenings found = FindOpenings(room, scene);
  EXPECT_GT(found.openings.List().size(), 0u);
  EXPECT_LT(found.openings.List().size(), MostOpenings);
  EXPECT_EQ(found.notes.tooMany, 0u);
  std::size_t crossing = 0;
  constexpr std::uint32_t Rays = 1000;
  for (std::uint32_t i = 0; i < Rays; ++i)
  {
    // From the floor's middle to points of the dome's rim: all light passes the dome.
    const double angle = 2.4 * i, radius = std::sqrt((i + 0.5) / Rays);
    const glm::dvec3 to(0.97 * radius * std::cos(angle), 0.97 * radius * std::sin(angle), 1.0);
    const glm::dvec3 from(0.0, 0.0, -0.9);
    const Ray ray{ glm::vec3(scene.GetPlacement().PointToScene(from)),
      glm::vec3(glm::normalize(to - from)) };
    crossing += found.openings.FirstCrossing(ray, false) ? 1 : 0;
  }
  // Beside the polygons of neighbouring parts there may be gaps at their common edges.
  EXPECT_GT(crossing, Rays * 95 / 100);
  for (const Opening& opening : found.openings.List())
  {
    EXPECT_LT(opening.normal.z, 0.0f);
  }
}

TEST(Openings, AreMarked)
{
  const Surface glazed = Together(Room({ Window }), PaneIn(Window));
  ExpectFound(Marked(glazed, 2, OpeningMark::NoOpening), {});
  Expected marked = InWindow;
  marked.kind = OpeningKind::Marked;
  ExpectFound(Marked(glazed, 2, OpeningMark::Opening), { marked });
  // The facets of the wall with the window come first.
  Surface room = Room({ Window });
  room.openingOfFacet.assign(room.facets.size(), OpeningMark::None);
  room.openingOfFacet.front() = OpeningMark::NoOpening; // at a corner of the wall
  ExpectFound(room, { InWindow });
  room.openingOfFacet[2] = room.openingOfFacet[3] = OpeningMark::NoOpening; // below the window
  ExpectFound(room, {});
  // A mark makes no hole of a wall.
  const Surface closed = Marked(Room({}), 2, OpeningMark::Opening);
  ExpectFound(closed, {});
  EXPECT_EQ(Find(closed).notes.opaqueMarks.number, 2u);
  EXPECT_EQ(Find(closed).notes.opaqueMarks.first, closed.facets.size() - 2);
}

TEST(Openings, OfEverySizeInEveryPlace)
{
  const Surface room = Together(WithPointsApart(Room({ Window })), Ground(-0.1, true));
  for (const double scale : { 1e-3, 1.0, 1e3 })
  {
    for (const double shift : { 0.0, 1000.0 })
    {
      for (const bool toSingle : { false, true })
      {
        const glm::dvec3 by = scale * shift * glm::dvec3(1.0, -0.8, 0.1);
        Expected expected = InWindow;
        expected.centre = scale * expected.centre + by;
        ExpectFound(Moved(room, scale, by, toSingle), { expected }, scale);
      }
    }
  }
}

TEST(Openings, AreNoCracksOfRounding)
{
  // Each wall is turned by itself and back, so that corners in one place differ in their last bits.
  Surface room = WithPointsApart(Room({ Window }));
  for (std::size_t p = 0; p < room.points.size(); ++p)
  {
    const double angle = 0.1 * static_cast<double>(p % 7);
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](double sine)
    {
      const glm::dvec3 x = room.points[p];
      room.points[p] = { c * x.x - sine * x.y, sine * x.x + c * x.y, x.z };
    };
    turn(s);
    turn(-s);
  }
  ExpectFound(room, { InWindow });
  room.rounding = 0x1p-24;
  for (std::size_t p = 0; p < room.points.size(); ++p)
  {
    const double way = p % 3 == 0 ? 1.0 : p % 3 == 1 ? -1.0 : 0.0;
    room.points[p] *= 1.0 + way * 0x1p-24;
  }
  ExpectFound(room, { InWindow });
}

TEST(Openings, SeeTheSkyWhereItIs)
{
  // Cut out of the ground, a basement's light well looks up. Without sky above, there is none.
  const Surface room = Room({ Window });
  const Scene scene(room);
  const auto below = [](const glm::vec3& direction) { return direction.z < 0.0f; };
  EXPECT_EQ(FindOpenings(room, scene, below).openings.List().size(), 1u);
  const auto behind = [](const glm::vec3& direction) { return direction.x < 0.0f; };
  const FoundOpenings none = FindOpenings(room, scene, behind);
  EXPECT_TRUE(none.openings.IsEmpty());
  EXPECT_EQ(none.notes.withoutSky, 1u);
}

TEST(Openings, KeepTheLargest)
{
  // 10 x 10 holes, each a little wider than the one before.
  std::vector<Edges> holes;
  for (int i = 0; i < 100; ++i)
  {
    const double y = 0.1 + 0.38 * (i % 10), z = 0.1 + 0.28 * (i / 10);
    holes.push_back({ y, z, y + 0.1 + 0.001 * i, z + 0.1 });
  }
  const FoundOpenings found = Find(Room(holes));
  ASSERT_EQ(found.openings.List().size(), MostOpenings);
  EXPECT_EQ(found.notes.tooMany, 100 - MostOpenings);
  const std::string line = Illumination::OpeningLines(found, Scene(Room(holes)), true).front();
  EXPECT_NE(line.find("and 58 smaller ones"), std::string::npos) << line;
  const double scale = Scene(Room(holes)).GetPlacement().scale;
  EXPECT_NEAR(found.openings.List().back().Area() / (scale * scale), 0.1 * 0.136, 1e-5);
}

TEST(Openings, AreToldInWords)
{
  const auto lines = [](const Surface& surface)
  {
    const Scene scene(surface);
    return Illumination::OpeningLines(FindOpenings(surface, scene), scene, true);
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines(Room({})), Lines{ "openings used: none" });
  const Edges wide{ 0.5, 1.0, 3.0, 2.0 };
  Surface room = Together(Room({ wide }), PaneIn(wide));
  EXPECT_EQ(
    lines(room), Lines{ "openings used: 1 (2.5 m^2 in all): 2.5 m^2 at (4, 1.75, 1.5), a pane" });
  room.metresPerUnit = 10.0;
  EXPECT_EQ(lines(Marked(room, 2, OpeningMark::Opening)),
    Lines{ "openings used: 1 (250 m^2 in all): 250 m^2 at (4, 1.75, 1.5), marked" });
  EXPECT_EQ(lines(Marked(room, 4, OpeningMark::Opening)),
    (Lines{ "openings used: 1 (250 m^2 in all): 250 m^2 at (4, 1.75, 1.5), marked",
      "openings not used: 2 triangles are marked and let no light straight through" }));
  const Edges small{ 1.0, 0.25, 2.0, 0.75 };
  EXPECT_EQ(lines(Together(Room({ wide, small }), PaneIn(wide, 4.0))),
    Lines{ "openings used: 2 (3 m^2 in all): 2.5 m^2 at (4, 1.75, 1.5), a pane; 0.5 m^2 at (4, "
           "1.5, 0.5), a hole of the mesh" });
  EXPECT_EQ(lines(Wall({ 4, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 4, 3 }, { wide })),
    (Lines{ "openings used: none", "openings not used: 1 see as much sky from either side" }));
}

// Triangles between the points of a coarse grid: copies, T-junctions, branches, slivers, no area.
TEST(Openings, OfAnyTrianglesAreSoundAndTheSameOnAnyThreads)
{
  std::size_t number = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed)
  {
    Surface surface;
    for (int i = 0; i < 64; ++i)
    {
      surface.points.emplace_back(i % 4, i / 4 % 4, i / 16 % 4);
    }
    surface.normals.assign(64, { 0, 0, 1 });
    surface.facets.push_back({ 0, 1, 4 });
    for (std::uint32_t f = 0; f < 4 + seed; ++f)
    {
      const auto random = Philox({ f, 0, 0, 0 }, { seed, 0 });
      surface.facets.push_back({ random[0] % 64, random[1] % 64, random[2] % 64 });
      if (seed % 2 == 0) // corners next to each other
      {
        const unsigned a = random[0] % 64, u = random[3] % 3, v = (u + 1) % 3, steps[]{ 1, 4, 16 };
        surface.facets.back() = { a, (a + steps[u]) % 64, (a + steps[v]) % 64 };
      }
    }
    surface.materials = { Material(), ClearMaterial() };
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
    {
      surface.materialOfFacet.push_back(f % 5 == 0 ? 1 : 0);
    }
    const Scene scene(surface);
    const FoundOpenings found = FindOpenings(surface, scene);
    for (const Opening& opening : found.openings.List())
    {
      EXPECT_GT(opening.Area(), 0.0f);
      EXPECT_NEAR(glm::length(opening.normal), 1.0f, 1e-6f);
      EXPECT_TRUE(std::isfinite(opening.radius) && opening.radius > 0.0f);
      const Ray ray{ opening.PointAt(0.3f, 0.6f) - opening.normal, opening.normal };
      EXPECT_TRUE(found.openings.FirstCrossing(ray, true));
    }
    FoundOpenings again;
    Threads(1).Run([&] { again = FindOpenings(surface, scene); });
    ASSERT_EQ(again.openings.List().size(), found.openings.List().size());
    for (std::size_t i = 0; i < found.openings.List().size(); ++i)
    {
      EXPECT_EQ(again.openings.List()[i].triangles, found.openings.List()[i].triangles);
    }
    number += found.openings.List().size();
  }
  EXPECT_GT(number, 20u);
}

TEST(Openings, AreFoundInLittleTime)
{
  const Surface room = Together(Shapes::RoomWithSphere(100000),
    Together(Shapes::RoomWithWindow(30.0, 30.0, { -5, 5, 5, 15 }, 220), Ground(-40.0, true)));
  ASSERT_GT(room.facets.size(), 190000u);
  const auto start = std::chrono::steady_clock::now();
  const Scene scene(room);
  const auto ready = std::chrono::steady_clock::now();
  const FoundOpenings found = FindOpenings(room, scene);
  const std::chrono::duration<double> making = ready - start;
  const std::chrono::duration<double> finding = std::chrono::steady_clock::now() - ready;
  EXPECT_EQ(found.openings.List().size(), 1u);
  EXPECT_LT(finding.count(), 4.0 * making.count()); // a quadratic search takes hundreds of times
  RecordProperty("milliseconds", static_cast<int>(1e3 * finding.count()));
}
