// SPDX-License-Identifier: BSD-3-Clause
// Which vertices receive light in the second pass.
#include "PhotonTransport/gathering/VertexReceivers.h"

#include "Shapes.h"

#include <gtest/gtest.h>

using namespace PhotonTransport;

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
