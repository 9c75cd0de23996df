// SPDX-License-Identifier: BSD-3-Clause
// Directions in which rays go on from facets close to a receiver.
#include "PhotonTransport/gathering/NearGuide.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace PhotonTransport;

TEST(Warps, SquareOfDiskInvertsConcentricDisk)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(0.0f, 1.0f);
  for (int i = 0; i < 10'000; ++i)
  {
    const float u = number(random), v = number(random);
    const glm::vec2 back = SquareOfDisk(ConcentricDisk(u, v));
    EXPECT_NEAR(back.x, u, 1e-6f);
    EXPECT_NEAR(back.y, v, 1e-6f);
  }
  const glm::vec2 middle = SquareOfDisk({ 0.0f, 0.0f });
  EXPECT_EQ(middle.x, 0.5f);
  EXPECT_EQ(middle.y, 0.5f);
}

namespace
{

/// Light that is anything but even.
double LightFrom(const glm::vec3& direction)
{
  return 1.0 + std::sin(7.0 * double{ direction.x }) + (direction.y > 0.3f ? 5.0 : 0.0) +
    double{ direction.z } * double{ direction.z };
}

} // namespace

// Whatever the guide says, a weighed direction stands for one that is drawn by the cosine: the same
// light on average, and no weight above one over the share of the rays that follow the cosine.
TEST(NearGuide, DoesNotChangeTheLight)
{
  constexpr std::size_t Size = 8;
  std::vector<float> found(Size * Size, 0.0f);
  found[2 * Size + 5] = 50.0f;
  found[6 * Size + 1] = 9.0f;
  Guide guide;
  guide.Set(Size, found);
  const glm::vec3 ofReceiver(0.0f, 0.0f, 1.0f);
  NearGuide near;
  std::vector<std::uint8_t> isNear(Size * Size, 0);
  isNear[6 * Size + 1] = isNear[3 * Size + 3] = 1;
  near.Set(guide, Frame(ofReceiver), isNear);
  for (const glm::vec3& normal : { glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(1.0f, 0.0f, 0.0f),
         glm::normalize(glm::vec3(-1.0f, 2.0f, 0.5f)), glm::vec3(0.0f, 0.0f, -1.0f) })
  {
    // Places in the middles of rectangles; the first number alone decides the cell of the guide.
    constexpr int Rows = 8192, Columns = 256, Places = Rows * Columns;
    double guided = 0.0, byCosine = 0.0, weights = 0.0;
    float largest = 0.0f;
    for (int i = 0; i < Places; ++i)
    {
      const float u = (static_cast<float>(i / Columns) + 0.5f) / Rows;
      const float v = (static_cast<float>(i % Columns) + 0.5f) / Columns;
      const NearGuide::Way way = near.At(normal, u, v);
      EXPECT_TRUE(way.weight == 0.0f || glm::dot(way.direction, normal) > 0.0f);
      guided += double{ way.weight } * LightFrom(way.direction);
      weights += double{ way.weight };
      largest = std::max(largest, way.weight);
      byCosine += LightFrom(Frame(normal).ToWorld(CosineHemisphere(u, v)));
    }
    // The error of the middles is that of the guide's edges; with 4096 columns it is 0.0004.
    EXPECT_NEAR(weights / Places, 1.0, 0.002);
    EXPECT_NEAR(guided / byCosine, 1.0, 0.002);
    EXPECT_LT(largest, 1.0f / 0.6f + 1e-5f);
  }
}

// A guide to what is close by tells a facet beside the receiver nothing: all rays follow the
// cosine.
TEST(NearGuide, LeavesLightFromCloseByToTheCosine)
{
  constexpr std::size_t Size = 4;
  std::vector<float> found(Size * Size, 0.0f);
  found[5] = 3.0f;
  Guide guide;
  guide.Set(Size, found);
  NearGuide near;
  near.Set(guide, Frame(glm::vec3(0.0f, 0.0f, 1.0f)), std::vector<std::uint8_t>(Size * Size, 1));
  const glm::vec3 normal(1.0f, 0.0f, 0.0f);
  for (const float u : { 0.0f, 0.3f, 0.9f, 1.0f - 0x1p-24f })
  {
    EXPECT_FLOAT_EQ(near.At(normal, u, 0.6f).weight, 1.0f);
  }
}
