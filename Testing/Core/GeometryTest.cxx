// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/BoundingCircle.h"
#include "PhotonTransport/geometry/FacetRings.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/geometry/Placement.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Warps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace PhotonTransport;

namespace
{

/// Rounding of a few products of numbers up to 1, in units of float's last place.
constexpr float FloatRounding = 8.0f * 0x1p-23f;

} // namespace

TEST(Frame, IsOrthonormalAndRightHandedForEveryNormal)
{
  PhotonSequence sample({ 1, 0, Sampling::Random }, 0);
  for (int i = 0; i < 10000; ++i, sample.Advance())
  {
    glm::vec3 normal = UniformSphere(sample.Emission(0), sample.Emission(1));
    normal = i == 0 ? glm::vec3(0, 0, -1) : i == 1 ? glm::vec3(0, 0, 1) : glm::normalize(normal);
    const Frame frame(normal);
    EXPECT_NEAR(glm::dot(frame.tangent, frame.bitangent), 0.0f, FloatRounding);
    EXPECT_NEAR(glm::dot(frame.tangent, normal), 0.0f, FloatRounding);
    EXPECT_NEAR(glm::dot(frame.bitangent, normal), 0.0f, FloatRounding);
    EXPECT_NEAR(glm::length(frame.tangent), 1.0f, FloatRounding);
    EXPECT_NEAR(glm::dot(glm::cross(frame.tangent, frame.bitangent), normal), 1.0f, FloatRounding);
  }
}

TEST(Placement, PutsTheBoxIntoTheUnitCubeByAPowerOfTwo)
{
  for (const double size : { 1e-6, 0.3, 1.0, 1e6 })
  {
    for (const double shift : { 0.0, 1e3, 1e7 })
    {
      const std::vector<glm::dvec3> points = { glm::dvec3(shift),
        glm::dvec3(shift + size, shift, shift), glm::dvec3(shift, shift + 0.5 * size, shift),
        glm::dvec3(1e300) };
      const Placement placement = FitPlacement(points, { { 0, 1, 2 } });
      int exponent = 0;
      EXPECT_EQ(std::frexp(placement.scale, &exponent), 0.5);
      const glm::dvec3 right = placement.PointToScene(points[1]);
      EXPECT_LE(right.x, 1.0);
      EXPECT_GT(right.x, 0.499); // at least half of the cube is used
    }
  }
}

// A fine building at the edge of a coarse site decides where the origin lies; where all is alike
// the middle of the box stays.
TEST(Placement, PutsTheOriginNextToTheFinestPart)
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> facets;
  const auto add = [&](const glm::dvec3& at, double size)
  {
    const auto first = static_cast<unsigned>(points.size());
    points.insert(points.end(), { at, at + glm::dvec3(size, 0, 0), at + glm::dvec3(0, size, 0) });
    facets.emplace_back(first, first + 1, first + 2);
  };
  for (int i = 0; i < 100; ++i)
  {
    add({ 1000.0 * (i % 10), 1000.0 * (i / 10), 0.0 }, 1000.0);
  }
  const glm::dvec3 middle(5000.0, 5000.0, 0.0);
  EXPECT_EQ(FitPlacement(points, facets).centre, middle);
  const glm::dvec3 building(9000.0, 500.0, 10.0);
  for (int i = 0; i < 12; ++i)
  {
    add(building + glm::dvec3(0.3 * i, 0.2 * i, 0.1 * i), 3.0);
  }
  const Placement placement = FitPlacement(points, facets);
  EXPECT_LT(glm::length(placement.centre - building), 20.0);
  for (const glm::dvec3& point : points)
  {
    const glm::dvec3 inScene = placement.PointToScene(point);
    EXPECT_LE(std::max({ std::fabs(inScene.x), std::fabs(inScene.y), std::fabs(inScene.z) }), 1.0);
  }
}

TEST(Placement, OfASinglePointDoesNotScale)
{
  const Placement placement = FitPlacement({ glm::dvec3(3.0) }, { { 0, 0, 0 } });
  EXPECT_EQ(placement.scale, 1.0);
  EXPECT_EQ(placement.PointToScene(glm::dvec3(3.0)), glm::dvec3(0.0));
}

TEST(FacetRings, ListEachVertexsFacets)
{
  const FacetRings rings(5, { { 0, 1, 2 }, { 2, 1, 3 } });
  const auto ring = [&](std::uint32_t v)
  { return std::multiset<std::uint32_t>(rings.Of(v).begin(), rings.Of(v).end()); };
  EXPECT_EQ(ring(0), (std::multiset<std::uint32_t>{ 0 }));
  EXPECT_EQ(ring(1), (std::multiset<std::uint32_t>{ 0, 1 }));
  EXPECT_EQ(ring(2), (std::multiset<std::uint32_t>{ 0, 1 }));
  EXPECT_EQ(ring(3), (std::multiset<std::uint32_t>{ 1 }));
  EXPECT_TRUE(ring(4).empty());
}

namespace
{

/// The circle holds all points, and its rim has points that no half circle leaves out: it is the
/// smallest.
void ExpectSmallest(const std::vector<glm::dvec2>& points)
{
  const Circle circle = BoundingCircle(points);
  std::vector<double> angles;
  for (const glm::dvec2& point : points)
  {
    const glm::dvec2 d = point - circle.centre;
    EXPECT_LE(glm::length(d), circle.radius);
    if (glm::length(d) > circle.radius * (1.0 - 1e-9))
    {
      angles.push_back(std::atan2(d.y, d.x));
    }
  }
  std::sort(angles.begin(), angles.end());
  ASSERT_GE(angles.size(), 2u);
  angles.push_back(angles.front() + 2.0 * 3.14159265358979);
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
  {
    EXPECT_LE(angles[i + 1] - angles[i], 3.14159265358979 * (1.0 + 1e-6));
  }
}

} // namespace

TEST(BoundingCircle, IsTheSmallest)
{
  std::vector<glm::dvec2> cloud, ring, line, grid;
  PhotonSequence sample({ 4, 0, Sampling::Random }, 0);
  for (int i = 0; i < 2000; ++i, sample.Advance())
  {
    cloud.emplace_back(sample.Emission(0), 2.0 * sample.Emission(1));
    ring.emplace_back(3.0 + std::cos(0.01 * i), std::sin(0.01 * i));
    line.emplace_back(0.3 * i, 0.1 * i);
    grid.emplace_back(i % 40, i / 40);
  }
  ExpectSmallest(cloud);
  ExpectSmallest(ring);
  ExpectSmallest(line);
  ExpectSmallest(grid);
  ExpectSmallest({ { 0, 0 }, { 1, 0 } });
  ExpectSmallest({ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0, 0 }, { 0.5, 0 } });
  EXPECT_EQ(BoundingCircle({ { 2.0, 3.0 } }).radius, 0.0);
}
