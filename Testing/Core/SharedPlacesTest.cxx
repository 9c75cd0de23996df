// SPDX-License-Identifier: BSD-3-Clause
// Facets in one plane that face the same way: each gets the whole light.
#include "PhotonTransport/scene/DataRounding.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include "RandomNumbers.h"
#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;

namespace
{

const glm::dvec3 U(3.1, 0.7, 1.2), V(-0.9, 2.8, 0.4); // across a tilted floor

Surface Patch(double u, double v, double width, double height, int cells)
{
  return Shapes::Rectangle(u * U + v * V, width * U, height * V, cells);
}

Surface Floor(int cells)
{
  return Patch(0.0, 0.0, 1.0, 1.0, cells);
}

struct Lit
{
  explicit Lit(const Surface& surface, std::uint64_t photons = 400'000)
    : scene(surface)
  {
    ParallelLight light;
    light.direction = -glm::normalize(glm::cross(U, V)) + 0.1 * glm::normalize(U);
    light.illuminance = 1000.0;
    TraceSettings settings;
    settings.threads = 1;
    settings.registerBackSide = true;
    IlluminationRun run(this->scene, light, settings);
    run.Advance({ photons });
    this->map = run.Front();
    this->balance = run.Balance();
    this->expected = 1000.0 / std::sqrt(1.01);
  }

  /// All points read the whole light, within four of their standard errors or of the mean one.
  void ExpectWholeLight() const
  {
    double weighted = 0.0, areas = 0.0, squares = 0.0;
    std::size_t number = 0;
    for (std::size_t v = 0; v < this->map.direct.size(); ++v)
    {
      const double area = this->scene.VertexAreas()[v];
      if (area > 0.0)
      {
        weighted += area * this->map.direct[v];
        areas += area;
        squares += std::pow(this->map.direct[v] - this->expected, 2);
        ++number;
        // No point lacks half of its light or has it twice, however few its photons.
        EXPECT_NEAR(this->map.direct[v], this->expected, 0.3 * this->expected) << "point " << v;
      }
    }
    EXPECT_NEAR(weighted / areas, this->expected, 0.01 * this->expected);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(number)), 0.08 * this->expected);
    EXPECT_EQ(this->balance.emitted, this->balance.absorbed + this->balance.escaped);
  }

  Scene scene;
  IlluminationMap map;
  PhotonBalance balance;
  double expected = 0.0;
};

} // namespace

TEST(SharedPlaces, NeighboursShareNone)
{
  for (const Surface& surface : { Floor(20), Shapes::Icosphere(3, Shapes::Facing::Outward),
         Shapes::Torus(40, 20, Shapes::Facing::Outward), Shapes::RoomWithSphere(10'000),
         Shapes::Disk(1.0, 0.0, 200, 1, true),
         Shapes::Together(Patch(0.0, 0.0, 0.5, 1.0, 7), Patch(0.5, 0.0, 0.5, 1.0, 12)) })
  {
    const SharedPlaceNotes notes = Scene(surface).Notes().sharedPlaces;
    EXPECT_EQ(notes.copies.facets + notes.inPart.facets, 0u) << surface.facets.size();
  }
}

TEST(SharedPlaces, CopiesCountOnce)
{
  const Surface floor = Floor(10);
  const Lit alone(floor);
  alone.ExpectWholeLight();
  Surface copy = floor;
  for (glm::uvec3& facet : copy.facets)
  {
    facet = { facet.y, facet.x, facet.z }; // the other way round, the normals as before
  }
  const Lit twice(Shapes::Together(floor, copy));
  twice.ExpectWholeLight();
  EXPECT_EQ(twice.scene.Notes().sharedPlaces.copies.facets, 200u);
  const Lit thrice(Shapes::Together(Shapes::Together(copy, floor), copy));
  for (std::size_t v = 0; v < floor.points.size(); ++v)
  {
    const double lux = alone.map.direct[v];
    EXPECT_NEAR(twice.map.direct[v], lux, 1e-5 * lux);
    EXPECT_NEAR(twice.map.direct[v + floor.points.size()], lux, 1e-5 * lux);
    EXPECT_NEAR(thrice.map.direct[v + floor.points.size()], lux, 1e-5 * lux);
    EXPECT_EQ(twice.map.photonHits[v], alone.map.photonHits[v]);
  }
}

TEST(SharedPlaces, OneCopyOfAFacetLeavesItsPointsAsTheyAre)
{
  const Surface floor = Floor(10);
  const Lit alone(floor);
  const glm::uvec3 ids = floor.facets[57];
  for (unsigned shared = 0; shared < 8; ++shared) // corners whose points are the facet's own
  {
    Surface surface = floor;
    glm::uvec3 copy = ids;
    for (int corner = 0; corner < 3; ++corner)
    {
      if (((shared >> corner) & 1u) == 0)
      {
        copy[corner] = static_cast<unsigned>(surface.points.size());
        surface.points.push_back(floor.points[ids[corner]]);
        surface.normals.push_back(floor.normals[ids[corner]]);
      }
    }
    surface.facets.emplace_back(copy.z, copy.x, copy.y);
    surface.materialOfFacet.push_back(0);
    const Lit lit(surface);
    lit.ExpectWholeLight();
    EXPECT_EQ(lit.scene.Notes().sharedPlaces.copies.facets, 1u);
    for (std::size_t v = 0; v < floor.points.size(); ++v)
    {
      EXPECT_NEAR(lit.map.direct[v], alone.map.direct[v], 1e-5 * alone.map.direct[v]);
      EXPECT_EQ(lit.scene.VertexAreas()[v], alone.scene.VertexAreas()[v]);
    }
  }
}

TEST(SharedPlaces, PatchesOnAFloorAllGetTheWholeLight)
{
  RandomNumbers random(7);
  for (int scene = 0; scene < 12; ++scene)
  {
    Surface surface = Floor(1 + scene);
    for (int patch = 0; patch < 4; ++patch)
    {
      const double width = 0.2 + 0.3 * double{ random.Unit() },
                   height = 0.2 + 0.3 * double{ random.Unit() };
      const Surface more =
        Patch(double{ random.Unit() } * (1.0 - width), double{ random.Unit() } * (1.0 - height),
          width, height, 1 + static_cast<int>(double{ random.Unit() } * 4.0));
      surface = patch % 2 == 0 ? Shapes::Together(surface, more) : Shapes::Together(more, surface);
    }
    const Lit lit(surface);
    lit.ExpectWholeLight();
    EXPECT_GT(lit.scene.Notes().sharedPlaces.inPart.facets, 4u);
  }
}

TEST(SharedPlaces, TheLastMaterialCountsWhateverTheRayMeets)
{
  const Surface black = Floor(3);
  const Surface white = Shapes::WithReflectance(Floor(4), 1.0f);
  const Lit whiteLast(Shapes::Together(black, white));
  EXPECT_EQ(whiteLast.balance.absorbed, 0u);
  const Lit blackLast(Shapes::Together(white, black));
  EXPECT_EQ(blackLast.balance.absorbed + blackLast.balance.escaped, blackLast.balance.emitted);
  EXPECT_EQ(blackLast.balance.segments, blackLast.balance.emitted); // nothing is reflected
  EXPECT_EQ(blackLast.scene.Notes().sharedPlaces.unlikeMaterials.facets, 50u);
}

namespace
{

/// A tilted floor with a carpet in its plane, far from the origin, in single precision.
Surface Rounded(const glm::dvec3& shift, bool known)
{
  Surface surface = Shapes::Together(Floor(8), Patch(0.23, 0.31, 0.4, 0.35, 5));
  for (glm::dvec3& point : surface.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Where GCC 12 vectorises two conversions in a row, it leaves both out; not so a store.
      const volatile float single = static_cast<float>(point[axis] + shift[axis]);
      point[axis] = double{ single };
    }
  }
  surface.rounding = known ? SingleHalfUnit : 0.0;
  return surface;
}

const glm::dvec3 Shifts[] = { { 10, 20, 5 }, { 100, 200, 30 }, { 1000, 2000, 50 } };

} // namespace

TEST(SharedPlaces, OnePlaneIsOneUpToTheRoundingOfTheData)
{
  for (const glm::dvec3& shift : Shifts)
  {
    SCOPED_TRACE(shift.x);
    const Lit black(Rounded(shift, true));
    black.ExpectWholeLight();
    const SharedPlaceNotes& notes = black.scene.Notes().sharedPlaces;
    EXPECT_EQ(notes.leftToChance.facets, 0u);
    EXPECT_GT(notes.inPart.facets, 50u);
    // Each sheet is off by half a unit in each coordinate at most.
    const double most = 2.0 * SingleHalfUnit * glm::length(shift + glm::dvec3(3.0));
    EXPECT_GT(notes.inPart.apart, 0.0);
    EXPECT_LE(notes.inPart.apart, most);
    // What leaves one of the sheets meets neither again.
    const Lit white(Shapes::WithReflectance(Rounded(shift, true), 1.0f));
    EXPECT_EQ(white.balance.segments, white.balance.emitted + black.balance.absorbed);
  }
}

// A wall drawn once for each side.
TEST(SharedPlaces, BacksAreInOnePlaceUpToTheRoundingOfTheData)
{
  for (const glm::dvec3& shift : Shifts)
  {
    SCOPED_TRACE(shift.x);
    Surface surface = Rounded(shift, true);
    for (std::size_t p = 81; p < surface.points.size(); ++p) // the carpet's
    {
      surface.normals[p] = -surface.normals[p];
    }
    const Lit black(surface);
    for (std::size_t v = 0; v < surface.points.size(); ++v)
    {
      EXPECT_NEAR(black.map.direct[v], v < 81 ? black.expected : 0.0, 0.3 * black.expected);
    }
    EXPECT_EQ(black.scene.Notes().thinGaps.number, 0u);
    // What leaves the floor stays above both, but for light that gets under the carpet's rim, which
    // lies up to twice the rounding above the floor, and is caught there.
    const Lit white(Shapes::WithReflectance(surface, 1.0f));
    const double rim = 2.0 * (0.4 * glm::length(U) + 0.35 * glm::length(V));
    const double height = 2.0 * SingleHalfUnit * glm::length(shift + glm::dvec3(3.0));
    const double caught =
      rim * height / glm::length(glm::cross(U, V)) * static_cast<double>(black.balance.absorbed);
    EXPECT_LE(static_cast<double>(white.balance.cutOff), caught + 4.0 * std::sqrt(caught));
  }
}

TEST(SharedPlaces, UnknownRoundingIsFoundOut)
{
  for (const glm::dvec3& shift : { Shifts[1], Shifts[2] })
  {
    SCOPED_TRACE(shift.x);
    const SharedPlaceNote note = Scene(Rounded(shift, false)).Notes().sharedPlaces.leftToChance;
    EXPECT_GT(note.facets, 1u);
    EXPECT_LT(note.first, 128u); // the floor's
    EXPECT_GE(note.second, 128u);
    EXPECT_GT(note.squareMetres, 0.0);
    EXPECT_GT(note.apart, 0.0);
    EXPECT_LE(note.apart, 2.0 * SingleHalfUnit * glm::length(shift + glm::dvec3(3.0)));
  }
}

// Two floors of equal squares, one a little above the other. They are in one place everywhere, or
// nowhere, or it is told.
TEST(SharedPlaces, SheetsAreInOnePlaceAsAWhole)
{
  const glm::dvec3 up = glm::normalize(glm::cross(U, V));
  int joined = 0, apart = 0;
  for (double gap = 1e-8; gap < 1e-3; gap *= 2.0)
  {
    SCOPED_TRACE(gap);
    Surface above = Floor(8);
    for (glm::dvec3& point : above.points)
    {
      point += gap * up;
    }
    const Lit lit(Shapes::Together(Floor(8), above), 50'000);
    const SharedPlaceNotes& notes = lit.scene.Notes().sharedPlaces;
    if (notes.leftToChance.facets > 0)
    {
      continue;
    }
    const bool inOnePlace = notes.inPart.facets + notes.copies.facets > 0;
    EXPECT_EQ(notes.inPart.facets + 2 * notes.copies.facets, inOnePlace ? 256u : 0u);
    ++(inOnePlace ? joined : apart);
    const std::size_t points = above.points.size();
    for (std::size_t v = 0; v < points; ++v)
    {
      EXPECT_NEAR(lit.map.direct[points + v], lit.expected, 0.3 * lit.expected);
      EXPECT_NEAR(lit.map.direct[v], inOnePlace ? lit.expected : 0.0, 0.3 * lit.expected);
    }
  }
  EXPECT_GT(joined, 3);
  EXPECT_GT(apart, 3);
}

TEST(SharedPlaces, RoundingIsANumberFromZeroOn)
{
  for (const double rounding : { -1e-9, std::nan(""), HUGE_VAL })
  {
    Surface floor = Floor(1);
    floor.rounding = rounding;
    EXPECT_THROW(Scene{ floor }, InvalidInput);
  }
}

TEST(SharedPlaces, ACopyShinesOnce)
{
  Surface wall = Shapes::WithExitance(Floor(2), 0.0f);
  const Surface lamp = Shapes::WithExitance(Floor(2), 100.0f);
  const TraceSettings settings;
  const Scene alone(lamp), onWall(Shapes::Together(wall, lamp)),
    twice(Shapes::Together(lamp, lamp));
  const double flux = PhotonTracer(alone, EmittingFacets(), settings).Flux();
  EXPECT_NEAR(PhotonTracer(onWall, EmittingFacets(), settings).Flux(), flux, 1e-12 * flux);
  EXPECT_NEAR(PhotonTracer(twice, EmittingFacets(), settings).Flux(), flux, 1e-12 * flux);
}
