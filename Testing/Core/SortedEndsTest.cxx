// SPDX-License-Identifier: BSD-3-Clause
// The search for open edges that lie beside each other: what it finds, and how long it takes.
#include "PhotonTransport/refinement/SortedEnds.h"
#include "PhotonTransport/refinement/Refinement.h"
#include "PhotonTransport/scene/Surface.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <random>
#include <vector>

using namespace PhotonTransport;

// Against a look at every end; a quarter of them lie in one plane, on a grid, in places of several.
TEST(SortedEnds, EndsOfEdgesAreFoundInABox)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<End> ends;
  for (std::uint32_t i = 0; i < 20'000; ++i)
  {
    const glm::dvec3 point(uniform(generator), uniform(generator), uniform(generator));
    const glm::dvec3 onGrid(
      std::round(20.0 * point.x) / 20.0, std::round(20.0 * point.y) / 20.0, 0);
    ends.push_back({ i % 4 == 0 ? onGrid : point, i });
  }
  const SortedEnds sorted(ends);
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec3 least = ends[static_cast<std::size_t>(i)].point;
    const glm::dvec3 most = least + glm::dvec3(i % 3 == 0 ? 0.0 : 0.2, 0.1, i % 2 == 0 ? 0.0 : 0.3);
    std::vector<std::uint32_t> found, wanted;
    sorted.ForEachWithin(least, most, [&](const End& end) { found.push_back(end.edge); });
    for (const End& end : ends)
    {
      if (glm::max(end.point, least) == end.point && glm::min(end.point, most) == end.point)
      {
        wanted.push_back(end.edge);
      }
    }
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, wanted);
  }
}

// A search that looked through a slab of the scene for each open edge took 60 times as long.
TEST(SortedEnds, FacetsThatAreAllApartTakeLittleTime)
{
  constexpr unsigned Facets = 100'000;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Surface loose;
  for (unsigned i = 0; i < Facets; ++i)
  {
    const glm::dvec3 place(uniform(generator), uniform(generator), uniform(generator));
    for (const glm::dvec3& side : { glm::dvec3(0, 0, 0), { 0.02, 0, 0.01 }, { 0, 0.02, 0.01 } })
    {
      loose.points.push_back(place + uniform(generator) * side);
      loose.normals.emplace_back(0, 0, 1);
    }
    loose.facets.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  const std::clock_t start = std::clock(); // of the processor, which others may use as well
  RefinementLimits limits;
  limits.turn = 0.1;
  const Refinement refinement({ loose.points, loose.normals, loose.facets }, limits);
  const auto seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_TRUE(refinement.IsTrivial());
  EXPECT_LT(seconds, 8.0);
}
