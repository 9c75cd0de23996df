// SPDX-License-Identifier: BSD-3-Clause
// Light at a point by shadow rays where something stands in between.
#include "DirectLightRig.h"
#include "TracedMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = References::Pi;
constexpr double FloatRounding = 2e-5;

/// A square of a material in the plane z = height, and a small floor far below.
Surface Plate(double from, double height, const Material& material)
{
  Surface plate = Shapes::Rectangle({ from, -6, height }, { 6, 0, 0 }, { 0, 12, 0 }, 1);
  plate.materials = { material };
  return Shapes::Together(
    plate, Shapes::Rectangle({ -0.1, -0.1, -5 }, { 0.2, 0, 0 }, { 0, 0.2, 0 }, 1));
}

Material Pane(float clear, float diffuse, float index)
{
  Material pane;
  pane.clearTransmittance = Colour(clear);
  pane.diffuseReflectance = Colour(diffuse);
  pane.refractiveIndex = index;
  return pane;
}

} // namespace

// The edge of a plate hides a part of a panel that a plane through the receiver cuts off, so the
// penumbra has a closed form. There rays to the outline decide how many samples follow; the mean
// must stay exact, and the variance must be what the estimates spread by.
TEST(DirectLight, InAPenumbraIsExactAndTellsItsError)
{
  const RectangleLamp lamp{ { 0, 0, 2 }, { 0, 0, -1 }, 1.0, 1.0, 400.0 };
  const std::vector<glm::dvec3> corners{ { -0.5, -0.5, 2 }, { 0.5, -0.5, 2 }, { 0.5, 0.5, 2 },
    { -0.5, 0.5, 2 } };
  const DirectLightRig rig(Plate(0.0, 1.0, {}), lamp);
  const glm::dvec3 normal(0, 0, 1);
  for (const unsigned samples : { 8u, 16u, 64u })
  {
    double told = 0.0, spread = 0.0, chi2 = 0.0;
    constexpr int Places = 60;
    constexpr std::uint32_t Seeds = 200;
    for (int i = 0; i < Places; ++i)
    {
      // Full light ends at x = -0.5. The umbra begins at 0.5; shortly before, few seeds see light,
      // and their spread says little.
      const glm::dvec3 point(-0.6 + 1.05 * i / (Places - 1), 0.1, 0.0);
      const glm::dvec3 edge(0, 0, 1);
      glm::dvec3 seen = glm::cross(edge - point, glm::dvec3(0, 1, 0));
      seen *= seen.x > 0.0 ? -1.0 : 1.0;
      const double exact = 400.0 * UnitExitance(point, normal, Clipped(corners, point, seen));
      const MeanOfSeeds all = Repeat([&](std::uint32_t seed)
        { return rig.At(point, normal, samples, seed, static_cast<std::uint64_t>(i)); },
        Seeds);
      told += all.toldVariance;
      spread += all.spread;
      const double tolerance = all.standardError + FloatRounding * (exact + 1.0);
      chi2 += (all.mean - exact) * (all.mean - exact) / (tolerance * tolerance) / Places;
    }
    // A mean of 60 squares of normal numbers spreads by sqrt(2 / 60).
    EXPECT_LT(chi2, 1.0 + 4.0 * std::sqrt(2.0 / Places)) << samples << " samples";
    EXPECT_NEAR(told / spread, 1.0, 0.1) << samples << " samples";
  }
}

TEST(DirectLight, PassesPanesAsPhotonsDo)
{
  const glm::dvec3 lamp(1.0, 0.5, 2.0);
  const PointLamp point{ lamp, 1000.0 };
  const auto at = [&](const Surface& surface, const glm::dvec3& place, ScatteringSet on) {
    return Total(DirectLightRig(surface, point, false, on).At(place, { 0, 0, 1 }, 16));
  };
  for (const double x : { 1.0, 2.0, 4.5 })
  {
    const glm::dvec3 place(x, 0.5, 0.0);
    const double d2 = 4.0 + (x - 1.0) * (x - 1.0);
    const double cosine = 2.0 / std::sqrt(d2);
    const double free = 1000.0 / (4.0 * Pi * d2) * cosine;
    const double sheet = References::SheetTransmittance(cosine, 1.5);
    const double tolerance = FloatRounding * free;
    EXPECT_NEAR(
      at(Plate(0.0, 1.0, Pane(1.0f, 0.0f, 1.5f)), place, AllScatterings), sheet * free, tolerance);
    // The diffuse share is taken off first.
    EXPECT_NEAR(at(Plate(0.0, 1.0, Pane(0.7f, 0.3f, 1.5f)), place, AllScatterings),
      0.7 * sheet * free, tolerance);
    const Surface two = Shapes::Together(
      Plate(0.0, 1.0, Pane(1.0f, 0.0f, 1.5f)), Plate(0.0, 1.2, Pane(1.0f, 0.0f, 1.5f)));
    EXPECT_NEAR(at(two, place, AllScatterings), sheet * sheet * free, tolerance);
    const ScatteringSet off = AllScatterings & ~SetOf(Scattering::ClearTransmission);
    EXPECT_EQ(at(Plate(0.0, 1.0, Pane(1.0f, 0.0f, 1.5f)), place, off), 0.0);
    const Surface wall =
      Shapes::Together(Plate(0.0, 1.0, Pane(1.0f, 0.0f, 1.5f)), Plate(0.0, 1.2, {}));
    EXPECT_EQ(at(wall, place, AllScatterings), 0.0);
  }
}

// A body of glass bends light, so none goes straight through it.
TEST(DirectLight, StopsAtBodies)
{
  Material glass = Pane(1.0f, 0.0f, 1.5f);
  glass.solid = true;
  const DirectLightRig rig(Plate(0.0, 1.0, glass), PointLamp{ { 1, 0.5, 2 }, 1000.0 });
  EXPECT_EQ(Total(rig.At({ 1, 0.5, 0 }, { 0, 0, 1 }, 16)), 0.0);
  EXPECT_GT(Total(rig.At({ -2, 0.5, 0 }, { 0, 0, 1 }, 16)), 0.0);
}

// The same flux lands on a floor as photons bring, in the shadow of a box and through a pane.
TEST(DirectLight, BringsTheFluxOfPhotons)
{
  constexpr int Cells = 64;
  Surface floor = Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, Cells);
  const std::size_t points = floor.points.size();
  Surface pane = Shapes::Rectangle({ -1, -1, 0.8 }, { 1, 0, 0 }, { 0, 2, 0 }, 1);
  pane.materials = { Pane(0.8f, 0.0f, 1.5f) };
  const Surface surface = Shapes::Together(Shapes::Together(floor, pane),
    Shapes::Box({ -0.2, -0.3, 0.3 }, { 0.2, 0.3, 0.5 }, 1, Facing::Outward));
  const std::vector<Lamp> lamps{ RectangleLamp{
                                   { 0.1, 0.2, 1.2 }, { 0.1, 0, -1 }, 0.5, 0.3, 100.0 },
    SphereLamp{ { 0.1, 0.2, 1.2 }, 0.2, 100.0 },
    LineLamp{ { 0.1, 0.2, 1.2 }, { 1, 1, 0 }, 0.8, 100.0 } };
  for (const Lamp& lamp : lamps)
  {
    const DirectLightRig rig(surface, lamp);
    TraceSettings settings;
    settings.maximumPathLength = 4;
    const TracedMap map(rig.scene, lamp, settings, 6'000'000);
    double photons = 0.0, photonVariance = 0.0, rays = 0.0, rayVariance = 0.0;
    DirectResult result;
    for (std::size_t v = 0; v < points; ++v)
    {
      const double area = rig.scene.VertexAreas()[v];
      photons += area * map.front.direct[v];
      photonVariance += std::pow(area * map.front.standardError[v], 2);
      const glm::dvec3 point =
        surface.points[v] * (1.0 - 1e-6) + glm::dvec3(0, 0, 1e-5); // within the floor's edge
      rig.light.At(rig.ReceiverAt(point, { 0, 0, 1 }), 64, 1, v, result);
      rays += area * Total(result);
      rayVariance += area * area * result.variance;
    }
    // Photons of a cell count for three vertices, so its variance counts up to three times less in
    // the sum of independent ones; the trapezoidal rule errs by some h^2 / 12 of the light.
    const double tolerance =
      4.5 * std::sqrt(3.0 * photonVariance + rayVariance) + photons / (Cells * Cells);
    EXPECT_NEAR(rays, photons, tolerance);
    EXPECT_LT(tolerance, 0.01 * photons);
  }
}

// Rays must neither be stopped by the facets at their own ends nor slip through edges: in a closed
// room, also as a small part of a large site, a lamp inside is seen from everywhere, and one
// outside from nowhere.
TEST(DirectLight, IsNeitherStoppedAtItsEndsNorLeaksThroughEdges)
{
  const Surface room = Shapes::Box({ -2, -2, 0 }, { 2, 2, 3 }, 6, Facing::Inward);
  const Surface site = Shapes::Together(
    room, Shapes::Rectangle({ -3000, -2000, -1 }, { 6000, 0, 0 }, { 0, 5000, 0 }, 3));
  const std::vector<glm::dvec3> corners{ { -1, -1, 3 }, { 1, -1, 3 }, { 1, 1, 3 }, { -1, 1, 3 } };
  // In the ceiling's plane, from which it is put clear.
  const RectangleLamp recessed{ { 0, 0, 3 }, { 0, 0, -1 }, 2.0, 2.0, 100.0 };
  for (const Surface& surface : { room, site })
  {
    const DirectLightRig inside(surface, recessed);
    const DirectLightRig outside(
      surface, RectangleLamp{ { 0, 0, 3.5 }, { 0, 0, -1 }, 5.0, 5.0, 1.0 });
    const DirectLightRig above(surface, PointLamp{ { 1, 2, 900 }, 1e9 });
    const double squareMetres = inside.scene.SquareMetresPerSceneArea();
    for (std::uint32_t f = 0; f < room.facets.size(); ++f)
    {
      const glm::vec3 normal = inside.scene.Facets()[f].normal;
      for (const glm::vec3& place :
        { glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f),
          glm::vec3(0.5f, 0.0f, 0.5f), glm::vec3(0.3f, 0.3f, 0.4f) })
      {
        const glm::vec3 start = inside.scene.SafeOrigin(f, place, true);
        const Receiver receiver{ normal, { { start, normal } }, start };
        DirectResult result;
        inside.light.At(receiver, 16, 1, f, result);
        EXPECT_EQ(result.variance, 0.0) << "facet " << f; // not one ray was stopped
        const glm::dvec3 point = glm::dvec3(start) * std::sqrt(squareMetres);
        const Placement& placement = inside.scene.GetPlacement();
        std::vector<glm::dvec3> seen;
        for (const glm::dvec3& corner : corners)
        {
          seen.push_back(placement.PointToScene(corner) * std::sqrt(squareMetres));
        }
        const bool isCeiling = normal.z < -0.5f;
        const double exact = isCeiling ? 0.0 : 25.0 * UnitExitance(point, glm::dvec3(normal), seen);
        // The lamp stands clear of the ceiling by up to 2^-16 of the coordinates.
        EXPECT_NEAR(Total(result), exact, 25.0 * 1e-4) << "facet " << f;
        outside.light.At(receiver, 16, 1, f, result);
        EXPECT_EQ(Total(result), 0.0) << "facet " << f;
        above.light.At(receiver, 16, 1, f, result);
        EXPECT_EQ(Total(result), 0.0) << "facet " << f;
      }
    }
  }
}

// Facets of the scene that shine: rays end where photons start, and not one is stopped there.
TEST(DirectLight, OfACeilingThatShinesReachesAllOfARoom)
{
  Surface room = Shapes::Box({ -2, -2, 0 }, { 2, 2, 3 }, 1, Facing::Inward);
  room.exitance.assign(room.facets.size(), Colour(0.0f));
  std::size_t shining = 0;
  for (std::size_t f = 0; f < room.facets.size(); ++f)
  {
    const bool isCeiling = room.points[room.facets[f].x].z == 3.0 &&
      room.points[room.facets[f].y].z == 3.0 && room.points[room.facets[f].z].z == 3.0;
    room.exitance[f] = Colour(isCeiling ? 40.0f : 0.0f);
    shining += isCeiling;
  }
  ASSERT_EQ(shining, 2u);
  const DirectLightRig rig(room, EmittingFacets{});
  for (std::uint32_t f = 0; f < room.facets.size(); ++f)
  {
    const glm::vec3 normal = rig.scene.Facets()[f].normal;
    for (const glm::vec3& place : { glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f),
           glm::vec3(0.5f, 0.0f, 0.5f), glm::vec3(0.3f, 0.3f, 0.4f) })
    {
      const Receiver receiver{ normal, { { rig.scene.SafeOrigin(f, place, true), normal } } };
      DirectResult result;
      rig.light.At(receiver, 64, 1, f, result);
      EXPECT_EQ(result.variance, 0.0) << "facet " << f;
      EXPECT_EQ(Total(result) > 0.0, normal.z > -0.5f) << "facet " << f;
    }
  }
}
