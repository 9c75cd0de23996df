// SPDX-License-Identifier: BSD-3-Clause
// The search for facets in one place: it may miss none that overlap, and finds none in sound
// meshes.
#include "Shapes.h"

#include "PhotonTransport/scene/CloseFacets.h"
#include "PhotonTransport/scene/FacetOverlap.h"
#include "PhotonTransport/scene/PlaceKeys.h"
#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

using namespace PhotonTransport;

namespace
{

struct Mesh
{
  LargeArray<glm::vec3> positions;
  LargeArray<Facet> facets;

  /// A facet of points of its own. @return Whether it has an area.
  bool Add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
  {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    if (!(glm::length(normal) > 0.0f))
    {
      return false;
    }
    const auto first = static_cast<std::uint32_t>(this->positions.size());
    this->positions.insert(this->positions.end(), { a, b, c });
    this->facets.push_back({ { first, first + 1, first + 2 }, 0.0f, glm::normalize(normal), 0.0f });
    return true;
  }

  /// @param axis Along which it is seen.
  PlaneTriangle Triangle(std::uint32_t facet, int axis) const
  {
    const std::uint32_t first = 3 * facet;
    return { facet, this->positions[first], this->positions[first + 1], this->positions[first + 2],
      axis };
  }

  PlaneTriangle Triangle(std::uint32_t facet) const
  {
    return this->Triangle(facet, BestAxis(this->facets[facet].normal));
  }
};

/// Facets of all sizes in a few planes, which face either way.
Mesh FacetsInFewPlanes(unsigned seed)
{
  std::mt19937 random(seed);
  const auto whole = [&](int most) { return static_cast<float>(random() % most); };
  Mesh mesh;
  while (mesh.facets.size() < 600)
  {
    const int axis = static_cast<int>(random() % 3);
    const float height = 0.25f * whole(4) - 0.5f;
    const float size = random() % 8 == 0 ? 0.25f : 0.01f;
    const glm::vec2 corner(0.125f * whole(8) - 0.5f, 0.125f * whole(8) - 0.5f);
    glm::vec3 corners[3];
    for (glm::vec3& place : corners)
    {
      place[axis] = height;
      place[(axis + 1) % 3] = corner.x + size * whole(5);
      place[(axis + 2) % 3] = corner.y + size * whole(5);
    }
    mesh.Add(corners[0], corners[1], corners[2]);
  }
  return mesh;
}

std::vector<std::uint8_t> CloseFacetsOf(const Mesh& mesh)
{
  return FindCloseFacets(mesh.positions, mesh.facets, DataRounding(), 1024.0f);
}

/// Whether a point in the plane of a facet is in the facet.
bool Contains(const Mesh& mesh, std::uint32_t facet, const glm::dvec3& point)
{
  const glm::dvec3 normal(mesh.facets[facet].normal);
  const auto corner = [&](std::uint32_t c)
  { return glm::dvec3(mesh.positions[3 * facet + c % 3]); };
  bool inside = true;
  for (std::uint32_t c = 0; c < 3; ++c)
  {
    const glm::dvec3 edge = corner(c + 1) - corner(c);
    inside = inside && glm::dot(glm::cross(edge, point - corner(c)), normal) >= 0.0;
  }
  return inside;
}

/// How far a facet is in front of a point, along an axis.
double HeightOver(const Mesh& mesh, std::uint32_t facet, const glm::dvec3& point, int axis)
{
  const glm::dvec3 a(mesh.positions[3 * facet]), b(mesh.positions[3 * facet + 1]),
    c(mesh.positions[3 * facet + 2]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  return glm::dot(a - point, normal) / normal[axis];
}

/// How far two facets are apart where they have a part in common, at most, seen along an axis.
double Apart(const Mesh& mesh, const PlaneTriangle& one, const PlaneTriangle& other, int axis)
{
  double apart = 0.0;
  for (const glm::dvec2& corner : Intersection(one, other).corners)
  {
    glm::dvec3 point(0.0);
    point[(axis + 1) % 3] = corner.x;
    point[(axis + 2) % 3] = corner.y;
    apart = std::max(apart,
      std::fabs(
        HeightOver(mesh, one.facet, point, axis) - HeightOver(mesh, other.facet, point, axis)));
  }
  return apart;
}

} // namespace

TEST(CloseFacets, NoneIsMissing)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = FacetsInFewPlanes(seed);
    const std::vector<std::uint8_t> close = CloseFacetsOf(mesh);
    ASSERT_EQ(close.size(), mesh.facets.size());
    std::size_t pairs = 0;
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i)
    {
      for (std::uint32_t j = 0; j < i; ++j)
      {
        const PlaneTriangle one = mesh.Triangle(i), other = mesh.Triangle(j);
        const float cosine = glm::dot(mesh.facets[i].normal, mesh.facets[j].normal);
        const float apart = glm::dot(mesh.facets[i].normal,
          mesh.positions[3 * std::size_t{ i }] - mesh.positions[3 * std::size_t{ j }]);
        if (std::fabs(cosine) > SameSheet && apart == 0.0f && Meet(one, other))
        {
          const std::uint8_t bit = cosine > 0.0f ? FacesAlike : FacesOpposite;
          EXPECT_NE(close[i] & bit, 0) << i << " and " << j;
          EXPECT_NE(close[j] & bit, 0) << i << " and " << j;
          ++pairs;
        }
      }
    }
    EXPECT_GT(pairs, 100u);
  }
}

/// Two facets in planes of any direction, a little apart and inclined to each other.
TEST(CloseFacets, NoneThatIsALittleApartIsMissing)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  const glm::vec3 special[] = { { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 1, -1, 0 },
    { 1, 1, std::sqrt(2.0f) }, { 0.5f, 0.0f, std::sqrt(0.75f) } };
  std::size_t pairs = 0;
  for (unsigned trial = 0; trial < 20'000; ++trial)
  {
    const glm::vec3 normal = glm::normalize(trial % 2 == 0
        ? special[trial / 2 % std::size(special)]
        : glm::vec3(any(random), any(random), any(random)) + glm::vec3(0.0f, 0.0f, 1e-3f));
    const glm::vec3 u = glm::normalize(glm::cross(normal, glm::vec3(0.6f, -0.36f, 0.72f)));
    const glm::vec3 v = glm::cross(normal, u);
    const glm::vec3 centre = 0.4f * glm::vec3(any(random), any(random), any(random));
    const float size = std::ldexp(0.2f, -static_cast<int>(random() % 15));
    const glm::vec3 reach = glm::abs(centre);
    const float apart = 32.0f * SheetGap * std::max({ reach.x, reach.y, reach.z });
    Mesh mesh;
    for (int f = 0; f < 2; ++f)
    {
      const float height = apart * any(random);
      const auto corner = [&]
      {
        return centre + size * (any(random) * u + any(random) * v) +
          (height + 0.01f * size * any(random)) * normal;
      };
      mesh.Add(corner(), corner(), corner());
    }
    if (mesh.facets.size() < 2)
    {
      continue;
    }
    bool overlap = std::fabs(glm::dot(mesh.facets[0].normal, mesh.facets[1].normal)) > SameSheet;
    for (const int axis : { BestAxis(mesh.facets[0].normal), BestAxis(mesh.facets[1].normal) })
    {
      const PlaneTriangle one = mesh.Triangle(0, axis), other = mesh.Triangle(1, axis);
      const double most =
        MostExcess * double{ SheetGap } * double{ std::max(one.reach, other.reach) };
      overlap = overlap && Meet(one, other) && Apart(mesh, one, other, axis) < most;
    }
    if (overlap)
    {
      const std::vector<std::uint8_t> close = CloseFacetsOf(mesh);
      const bool alike = glm::dot(mesh.facets[0].normal, mesh.facets[1].normal) > 0.0f;
      EXPECT_NE(close[0] & (alike ? FacesAlike : MayBeBefore), 0) << trial;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 3000u);
}

TEST(CloseFacets, SliversThatAreCopiesAreFound)
{
  Mesh mesh; // lower than what neighbours may have in common
  for (int copy = 0; copy < 2; ++copy)
  {
    mesh.Add({ 0.5f, 0.5f, 0.1f }, { 0.9f, 0.5f, 0.1f }, { 0.7f, 0.5f + 0x1p-19f, 0.1f });
  }
  EXPECT_EQ(CloseFacetsOf(mesh), std::vector<std::uint8_t>(2, FacesAlike | MayBeBefore));
}

TEST(CloseFacets, NoneInASoundMesh)
{
  const Surface surface = Shapes::RoomWithSphere(200'000);
  Mesh mesh;
  for (const glm::dvec3& point : surface.points)
  {
    mesh.positions.emplace_back(0.25 * point);
  }
  for (const glm::uvec3& ids : surface.facets)
  {
    const glm::vec3 &a = mesh.positions[ids.x], &b = mesh.positions[ids.y],
                    &c = mesh.positions[ids.z];
    mesh.facets.push_back({ ids, 0.0f, glm::normalize(glm::cross(b - a, c - a)), 0.0f });
  }
  for (const bool shuffled : { false, true })
  {
    SCOPED_TRACE(shuffled);
    if (shuffled)
    {
      std::shuffle(mesh.facets.begin(), mesh.facets.end(), std::mt19937(1));
    }
    std::size_t besides = 0;
    for (const std::uint8_t bits : CloseFacetsOf(mesh))
    {
      EXPECT_EQ(bits & ~MayBeBefore, 0);
      besides += bits != 0;
    }
    EXPECT_LT(besides, mesh.facets.size() / 20); // those at the edges of the room and the poles
  }
}

/// Facets of any size and direction about one another's middles.
TEST(CloseFacets, NoneBeforeAMiddleIsMissing)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  std::size_t before = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const auto place = [&](float size)
    { return size * glm::vec3(any(random), any(random), any(random)); };
    Mesh mesh;
    const glm::vec3 centre = place(0.5f);
    const float size = std::ldexp(0.5f, -static_cast<int>(random() % 10));
    const glm::vec3 a = centre + place(size), b = centre + place(size), c = centre + place(size);
    const float height = glm::length(glm::cross(b - a, c - a)) /
      std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
    if (!(height > 32.0f * OriginOffset) || !mesh.Add(a, b, c))
    {
      continue; // too narrow for what the bit promises
    }
    const glm::vec3 middle = (a + b + c) / 3.0f;
    const glm::vec3 nearMiddle = middle + place(2.0f * OriginOffset);
    const float otherSize = std::ldexp(0.5f, -static_cast<int>(random() % 16));
    const glm::vec3 d = place(otherSize), e = place(otherSize);
    if (!mesh.Add(nearMiddle + d, nearMiddle + e, nearMiddle - d - e))
    {
      continue;
    }
    const float offset =
      OriginOffset * std::max({ std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z) });
    const glm::dvec3 normal(mesh.facets[0].normal), other(mesh.facets[1].normal);
    const double along = glm::dot(normal, other);
    const double way = glm::dot(glm::dvec3(nearMiddle) - glm::dvec3(middle), other) / along;
    const glm::dvec3 met = glm::dvec3(middle) + way * normal;
    if (std::fabs(way) <= double{ offset } && Contains(mesh, 1, met))
    {
      const std::vector<std::uint8_t> close = CloseFacetsOf(mesh);
      EXPECT_NE(close[0] & MayBeBefore, 0) << trial;
      ++before;
    }
  }
  EXPECT_GT(before, 100u);
}

TEST(CloseFacets, KeysAreSortedAndStable)
{
  std::mt19937_64 random(1);
  LargeArray<std::uint64_t> keys(300'000);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    // Few and many keys that are equal above, in the whole range.
    keys[i] = (i % 2 == 0 ? random() % 7 : random() >> 32) << 32 | i;
  }
  LargeArray<std::uint64_t> expected = keys;
  std::stable_sort(expected.begin(), expected.end(),
    [](std::uint64_t a, std::uint64_t b) { return a >> 32 < b >> 32; });
  SortByUpperHalf(keys);
  EXPECT_EQ(keys, expected);
}
