// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/ReplicateSums.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr std::size_t Vertices = 5;
constexpr std::size_t Replicates = 6;

VertexSums RandomSums(std::mt19937_64& random)
{
  const auto upTo = [&](std::uint64_t most) { return random() % (most + 1); };
  return { static_cast<FixedPoint>(upTo(1ull << 40)), static_cast<FixedPoint>(upTo(1ull << 40)),
    upTo(1000) };
}

} // namespace

// What replicates keep is less than what they get; nothing that maps are made of is lost.
TEST(SideSums, KeepWhatMapsNeed)
{
  std::mt19937_64 random(1);
  std::array<std::array<VertexSums, Vertices>, Replicates> expected{};
  ReplicateSums sums(Replicates, IlluminationSums(Vertices, true));
  for (int slice = 0; slice < 20; ++slice)
  {
    const std::size_t r = random() % Replicates;
    IlluminationSums part(Vertices, true);
    for (std::size_t v = 0; v < Vertices; ++v)
    {
      part.front[v] = RandomSums(random);
      part.back[v] = part.front[v];
      expected[r][v] += part.front[v];
    }
    sums.Add(r, part);
    for (const VertexSums& left : part.front)
    {
      EXPECT_EQ(left.direct, 0);
      EXPECT_EQ(left.indirect, 0);
      EXPECT_EQ(left.hits, 0u);
    }
  }
  for (std::size_t v = 0; v < Vertices; ++v)
  {
    VertexSums all;
    std::array<FixedPoint, Groups> direct{};
    for (std::size_t r = 0; r < Replicates; ++r)
    {
      all += expected[r][v];
      direct[r % Groups] += expected[r][v].direct;
      EXPECT_EQ(sums.front.weights[r][v], expected[r][v].direct + expected[r][v].indirect);
    }
    for (const SideSums* side : { &sums.front, &sums.back })
    {
      const VertexSums total = side->Total(v);
      EXPECT_EQ(total.direct, all.direct);
      EXPECT_EQ(total.indirect, all.indirect);
      EXPECT_EQ(total.hits, all.hits);
    }
    for (std::size_t g = 0; g < Groups; ++g)
    {
      EXPECT_EQ(sums.front.direct[g][v], direct[g]);
    }
  }
}
