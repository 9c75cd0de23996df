// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/geometry/FacetRings.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include "Shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Where = InvalidInput::Where;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

/// The spoilt surface must be refused with the place and a message that holds `words`.
void ExpectRefused(const std::function<void(Surface&)>& spoil, Where where, std::size_t index,
  const std::string& words)
{
  Surface surface = Shapes::Icosphere(0, Shapes::Facing::Outward);
  spoil(surface);
  try
  {
    const Scene scene(surface);
    FAIL() << "accepted; expected: " << words;
  }
  catch (const InvalidInput& error)
  {
    EXPECT_EQ(error.Kind, where);
    EXPECT_EQ(error.Index, index);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(Scene, RefusesBadInputByPlaceAndValue)
{
  ExpectRefused([](Surface& s) { s.facets.clear(), s.materialOfFacet.clear(); }, Where::Surface, 0,
    "no triangles");
  ExpectRefused([](Surface& s) { s.normals.pop_back(); }, Where::Surface, 0, "11 normals for 12");
  ExpectRefused([](Surface& s) { s.materialOfFacet.pop_back(); }, Where::Surface, 0,
    "19 indices of materials for 20");
  const auto expectReflectanceRefused = [](float value, std::size_t facet, const char* text)
  {
    ExpectRefused(
      [=](Surface& s)
      {
        s.materials.resize(s.materials.size() + 1);
        s.materials.back().diffuseReflectance = Colour(value);
        s.materialOfFacet[facet] = static_cast<std::uint32_t>(s.materials.size() - 1);
      },
      Where::Facet, facet, text);
  };
  expectReflectanceRefused(1.25f, 4, "1.25");
  expectReflectanceRefused(-0.5f, 5, "-0.5");
  expectReflectanceRefused(NaN, 6, "nan");
  ExpectRefused([](Surface& s) { s.points[7].y = NaN; }, Where::Point, 7, "not finite");
  ExpectRefused([](Surface& s) { s.facets[8].z = 12; }, Where::Facet, 8, "point 12 of 12");
  ExpectRefused(
    [](Surface& s) { s.exitance.assign(3, Colour(1.0f)); }, Where::Surface, 0, "3 exitances");
  ExpectRefused(
    [](Surface& s)
    {
      s.exitance.assign(20, Colour(1.0f));
      s.exitance[9].y = -2.0f;
    },
    Where::Facet, 9, "-2");
  ExpectRefused(
    [](Surface& s) { s.metresPerUnit = 0.0; }, Where::TraceSettings, 0, "metres per unit");
  ExpectRefused(
    [](Surface& s) { s.points.assign(12, glm::dvec3(1.0)); }, Where::Surface, 0, "zero area");
}

TEST(Scene, KeepsTheFrontOnTheNormalsSide)
{
  Surface surface = Shapes::Icosphere(2, Shapes::Facing::Outward);
  for (std::size_t f = 0; f < surface.facets.size(); f += 3)
  {
    std::swap(surface.facets[f].y, surface.facets[f].z);
  }
  const Scene scene(surface);
  EXPECT_EQ(scene.Notes().turnedFacets, (surface.facets.size() + 2) / 3);
  for (const Facet& facet : scene.Facets())
  {
    EXPECT_GT(glm::dot(facet.normal, scene.Vertices()[facet.vertices.x].normal), 0.9f);
  }
}

TEST(Scene, MendsNormalsThatSayNothing)
{
  Surface surface = Shapes::Icosphere(2, Shapes::Facing::Outward);
  surface.normals[0] = glm::dvec3(0.0);
  surface.normals[1] = glm::dvec3(NaN);
  surface.normals[2] *= 1e-200; // tiny and huge lengths still say where
  surface.normals[3] *= 1e200;
  const Scene scene(surface);
  EXPECT_EQ(scene.Notes().replacedNormals, 2u);
  for (std::size_t v = 0; v < 4; ++v)
  {
    // A ring of an icosphere is symmetric about its vertex to within a degree or so.
    EXPECT_GT(glm::dot(glm::dvec3(scene.Vertices()[v].normal), surface.points[v]), 0.999);
  }
}

TEST(Scene, DropsFacetsWithoutArea)
{
  Surface surface = Shapes::Icosphere(1, Shapes::Facing::Outward);
  const std::size_t facets = surface.facets.size();
  surface.facets.push_back({ 0, 0, 1 });
  surface.materialOfFacet.push_back(0);
  const Scene scene(surface);
  EXPECT_EQ(scene.Notes().droppedFacets, 1u);
  EXPECT_EQ(scene.Facets().size(), facets);
  EXPECT_EQ(scene.Notes().scatteringFacets[0], 0u);
}

// A third of every facet's area belongs to each corner, in square metres whatever the unit.
TEST(Scene, VertexAreasAddUpToTheSurface)
{
  Surface surface =
    Shapes::Box(glm::dvec3(0.0), glm::dvec3(200.0, 300.0, 400.0), 3, Shapes::Facing::Inward);
  surface.metresPerUnit = 0.01;
  const Scene scene(surface);
  double sum = 0.0;
  for (const double area : scene.VertexAreas())
  {
    sum += area;
  }
  EXPECT_NEAR(sum, 2.0 * (2 * 3 + 3 * 4 + 4 * 2), 52.0 * 1e-6); // float positions
}

// sinTilt promises: light that meets the vertex normal at -w.n >= sinTilt meets the whole ring.
TEST(Scene, TiltBoundsTheRing)
{
  const Scene scene(Shapes::UvSphere(16, 8, Shapes::Facing::Outward));
  std::vector<glm::uvec3> corners;
  for (const Facet& facet : scene.Facets())
  {
    corners.push_back(facet.vertices);
  }
  const FacetRings rings(scene.Vertices().size(), corners);
  std::size_t used = 0;
  for (std::uint32_t v = 0; v < scene.Vertices().size(); ++v)
  {
    const Vertex& vertex = scene.Vertices()[v];
    if (scene.VertexAreas()[v] == 0.0)
    {
      continue; // a pole that was merged into its neighbour
    }
    ++used;
    double largest = 0.0;
    for (const std::uint32_t f : rings.Of(v))
    {
      const glm::dvec3 n(scene.Facets()[f].normal);
      largest = std::max(largest, glm::length(glm::cross(n, glm::dvec3(vertex.normal))));
    }
    EXPECT_NEAR(vertex.sinTilt, largest, 1e-6);
  }
  EXPECT_EQ(scene.Notes().tiltedVertices, used);
  EXPECT_EQ(Scene(Shapes::Box(glm::dvec3(0.0), glm::dvec3(1.0), 2, Shapes::Facing::Inward))
              .Notes()
              .tiltedVertices,
    0u);
}

// A reflected ray starts above its own facet and, in an acute corner, in front of the other wall.
TEST(Scene, SafeOriginsStayInside)
{
  for (const double degrees : { 15.0, 40.0, 90.0 })
  {
    const Scene scene(Shapes::Wedge(degrees, Shapes::Facing::Inward));
    for (std::uint32_t facet = 0; facet < scene.Facets().size(); ++facet)
    {
      for (const glm::vec3 b : { glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1),
             glm::vec3(0.5f, 0.5f, 0), glm::vec3(0, 0.5f, 0.5f), glm::vec3(0.5f, 0, 0.5f) })
      {
        const glm::vec3 origin = scene.SafeOrigin(facet, b, true);
        for (const Facet& wall : scene.Facets())
        {
          const glm::vec3 corner = scene.Vertices()[wall.vertices.x].position;
          EXPECT_GT(glm::dot(glm::dvec3(origin) - glm::dvec3(corner), glm::dvec3(wall.normal)), 0.0)
            << degrees << " degrees";
        }
      }
    }
  }
}

TEST(Scene, TakesTheFrontOfTwoSheetsInOnePlace)
{
  Surface sheets;
  sheets.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 0 } };
  sheets.normals = { { 0, 0, -1 }, { 0, 0, -1 }, { 0, 0, -1 }, { 0, 0, 1 }, { 0, 0, 1 },
    { 0, 0, 1 } };
  sheets.facets = { { 0, 1, 2 }, { 3, 4, 5 } };
  sheets = Shapes::WithReflectance(sheets, 0.0f);
  const Scene scene(sheets);
  const Ray down{ { 0.0f, 0.0f, 1.0f }, { 0.0f, 0.0f, -1.0f } };
  Hit onBack{ 0, { 0.5f, 0.25f, 0.25f } };
  EXPECT_TRUE(scene.PreferFront(down, onBack));
  EXPECT_EQ(onBack.facet, 1u);
  EXPECT_EQ(onBack.barycentric, glm::vec3(0.25f, 0.25f, 0.5f)); // the same place
  // What has no front there stays.
  sheets.points[3].z = sheets.points[4].z = sheets.points[5].z = -1e-3;
  const Scene apart(sheets);
  Hit alone{ 0, { 0.5f, 0.25f, 0.25f } };
  EXPECT_FALSE(apart.PreferFront(down, alone));
  EXPECT_EQ(alone.facet, 0u);
}
