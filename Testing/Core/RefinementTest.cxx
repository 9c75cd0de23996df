// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/FacetParts.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>
#include <utility>

using namespace PhotonTransport;

namespace
{

using Key = std::tuple<float, float, float>;

Key KeyOf(const glm::vec3& p)
{
  return { p.x, p.y, p.z };
}

/// Edges at most 1.5 times as long as their middle is away from the origin.
bool LargeForItsDistance(const glm::vec3& a, const glm::vec3& b)
{
  return glm::length(b - a) > 1.5f * std::max(0x1p-12f, glm::length(0.5f * (a + b)));
}

/// A fan of facets about a point, with a rim at random distances.
std::vector<std::array<glm::vec3, 3>> Fan(const glm::vec3& centre, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  constexpr int Facets = 9;
  std::vector<glm::vec3> rim;
  for (int i = 0; i < Facets; ++i)
  {
    const float angle = 6.2831853f * static_cast<float>(i) / Facets;
    rim.emplace_back(std::cos(angle), std::sin(angle), 0.5f * number(random));
  }
  std::vector<std::array<glm::vec3, 3>> fan;
  for (int i = 0; i < Facets; ++i)
  {
    std::array<glm::vec3, 3> corners{ centre, rim[i], rim[(i + 1) % Facets] };
    std::rotate(corners.begin(), corners.begin() + i % 3, corners.end());
    if (i % 2 == 1)
    {
      std::swap(corners[0], corners[1]);
    }
    fan.push_back(corners);
  }
  return fan;
}

FacetPart Whole(std::uint32_t facet, const std::array<glm::vec3, 3>& corners)
{
  return { { facet, WholeFacet }, corners };
}

} // namespace

TEST(Subdivision, LeavesFacetsWholeWhoseEdgesAre)
{
  std::vector<FacetPart> parts;
  AppendParts(
    7, { glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0) },
    [](const glm::vec3&, const glm::vec3&) { return false; }, parts);
  EXPECT_TRUE(parts.empty());
}

// Every edge inside the fan belongs to two parts, bit for bit, and parts fill their facets.
TEST(Subdivision, PartsMeetWithoutGaps)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const auto fan = Fan(glm::vec3(0.003f * static_cast<float>(seed), 0.003f, 0.0f), seed);
    std::map<std::pair<Key, Key>, int> edges;
    int divided = 0;
    for (std::uint32_t f = 0; f < fan.size(); ++f)
    {
      std::vector<FacetPart> parts;
      AppendParts(f, fan[f], LargeForItsDistance, parts);
      EXPECT_NE(parts.size(), 1u);
      divided += !parts.empty();
      if (parts.empty())
      {
        parts.push_back(Whole(f, fan[f]));
      }
      double area = 0.0;
      for (const FacetPart& part : parts)
      {
        EXPECT_EQ(part.facet, f);
        // The share of the facet's area is the determinant of the corners' coordinates.
        area += std::fabs(glm::dot(glm::dvec3(part.corners[0]),
          glm::cross(glm::dvec3(part.corners[1]), glm::dvec3(part.corners[2]))));
        for (std::size_t i = 0; i < 3; ++i)
        {
          EXPECT_EQ(part.positions[i], PositionOf(part.corners[i], fan[f]));
          Key a = KeyOf(part.positions[i]), b = KeyOf(part.positions[(i + 1) % 3]);
          EXPECT_FALSE(LargeForItsDistance(part.positions[i], part.positions[(i + 1) % 3]));
          ++edges[{ std::min(a, b), std::max(a, b) }];
        }
      }
      EXPECT_EQ(area, 1.0); // exact, since all coordinates are
    }
    EXPECT_GT(divided, 0);
    int single = 0;
    for (const auto& [edge, count] : edges)
    {
      EXPECT_LE(count, 2);
      single += count == 1;
    }
    EXPECT_EQ(single, 9) << "only the rim's edges have one facet";
  }
}

TEST(Subdivision, APointOfAPartIsThePointOfItsFacet)
{
  const std::array<glm::vec3, 3> corners{ glm::vec3(-1, -1, 0.25f), glm::vec3(1, -1, 0.5f),
    glm::vec3(0.125f, 1, 0) };
  std::vector<FacetPart> parts;
  AppendParts(0, corners, LargeForItsDistance, parts);
  ASSERT_FALSE(parts.empty());
  for (const FacetPart& part : parts)
  {
    for (const glm::vec3& b : { glm::vec3(1, 0, 0), glm::vec3(0.25f, 0.25f, 0.5f) })
    {
      const glm::vec3 inFacet = PositionOf(part.InFacet(b), corners);
      const glm::vec3 inPart = PositionOf(b, part.positions);
      EXPECT_LE(glm::length(inFacet - inPart), 4.0f * 0x1p-24f);
    }
  }
}
