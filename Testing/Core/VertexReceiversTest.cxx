// SPDX-License-Identifier: BSD-3-Clause
// Which vertices receive light in the second pass, and where their rays start.
#include "PhotonTransport/gathering/VertexReceivers.h"

#include "Shapes.h"

#include "PhotonTransport/gathering/DirectLight.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace PhotonTransport;

namespace
{

/// The corner of a room, of three walls that share their points: the front is inside.
Surface SharedCorner()
{
  Surface corner;
  corner.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 },
    { 1, 0, 1 } };
  corner.normals = { { 1, 1, 1 }, { 0, 1, 1 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 },
    { 0, 1, 0 } };
  corner.facets = { { 0, 1, 4 }, { 0, 4, 2 }, { 0, 2, 5 }, { 0, 5, 3 }, { 0, 3, 6 }, { 0, 6, 1 } };
  corner.materials = { Material() };
  corner.materialOfFacet.assign(corner.facets.size(), 0);
  return corner;
}

/// What a small panel close to the corner sends to each of its points.
std::vector<Colour> LightFromAPanelInTheCorner(const Surface& corner)
{
  RectangleLamp panel;
  panel.centre = { 0.01, 0.003, 0.002 };
  panel.direction = { -2, -1, -1 };
  panel.width = panel.height = 0.001;
  const Scene scene(corner);
  const Emitter emitter(panel, scene, false);
  const FacetRoulettes materials = MakeRoulettes(scene.Materials(), scene.MaterialOfFacet(), false);
  const DirectLight light(scene, emitter, materials, AllScatterings);
  const FacetCells cells(scene, std::vector<float>(scene.Facets().size(), 1.0f), 1000);
  const VertexReceivers receivers(scene, cells);
  std::vector<Colour> all;
  for (std::uint32_t v = 0; v < corner.points.size(); ++v)
  {
    Receiver receiver;
    receivers.Make(v, true, receiver);
    DirectResult result;
    light.At(receiver, 8, 1, v, result);
    all.push_back(result.ofLamp.front());
  }
  return all;
}

} // namespace

// A panel has an extent, so it is seen from within the facets: from the first of them the light in
// the corner was another one in each order of the facets.
TEST(VertexReceivers, LightDoesNotDependOnTheOrderOfFacets)
{
  const Surface corner = SharedCorner();
  const std::vector<Colour> expected = LightFromAPanelInTheCorner(corner);
  EXPECT_GT(expected.front().x, 0.0f);
  Surface turned = corner;
  for (std::size_t i = 1; i < corner.facets.size(); ++i)
  {
    std::rotate(turned.facets.begin(), turned.facets.begin() + 1, turned.facets.end());
    EXPECT_EQ(LightFromAPanelInTheCorner(turned), expected) << i;
  }
  std::reverse(turned.facets.begin(), turned.facets.end());
  EXPECT_EQ(LightFromAPanelInTheCorner(turned), expected);
}

// A receiver without a normal would be a point in free space, which light of all directions
// reaches.
TEST(VertexReceivers, WithoutANormalNoLightIsReceived)
{
  Surface surface = Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 1);
  const std::size_t ofSheet = surface.points.size();
  for (const glm::dvec3& point : { glm::dvec3(3, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(3, 1, 0) })
  {
    surface.points.push_back(point);
    surface.normals.emplace_back(0.0); // and both sides of the sheet cancel
  }
  const auto first = static_cast<unsigned>(ofSheet);
  surface.facets.emplace_back(first, first + 1, first + 2);
  surface.facets.emplace_back(first, first + 2, first + 1);
  surface.materialOfFacet.resize(surface.facets.size(), 0);
  const Scene scene(surface);
  const FacetCells cells(scene, std::vector<float>(scene.Facets().size(), 1.0f), 1000);
  const VertexReceivers receivers(scene, cells);
  for (std::uint32_t v = 0; v < surface.points.size(); ++v)
  {
    Receiver receiver;
    receivers.Make(v, true, receiver);
    EXPECT_EQ(receiver.starts.empty(), v >= ofSheet) << v;
    EXPECT_EQ(receiver.IsInFreeSpace(), v >= ofSheet) << v;
    EXPECT_GT(scene.VertexAreas()[v], 0.0) << v;
  }
}
