// SPDX-License-Identifier: BSD-3-Clause
// Are the standard errors of the second pass true? Many seeds of places where light is hard: on
// faces, edges and in corners of a room, and in the border of a shadow.
#include "Comparison.h"
#include "GatheringTools.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr std::uint32_t Seeds = 32;

/// A room 4 x 4 x 3 with a box on its floor, below a panel beside it.
Surface RoomWithBox()
{
  const Surface room = Shapes::Box({ 0, 0, 0 }, { 4, 4, 3 }, 8, Facing::Inward);
  const Surface box = Shapes::Box({ 1.5, 1.5, 0 }, { 2.5, 2.5, 1 }, 2, Facing::Outward);
  return Shapes::WithReflectance(Shapes::Together(room, box), 0.6f);
}

struct Part
{
  const char* name;
  std::function<bool(const glm::dvec3& point)> counts;
};

int Borders(const glm::dvec3& p)
{
  const auto at = [](double x, double end) { return x == 0.0 || x == end ? 1 : 0; };
  return at(p.x, 4.0) + at(p.y, 4.0) + at(p.z, 3.0);
}

bool IsUnderBox(const glm::dvec3& p)
{
  return p.z == 0.0 && p.x >= 1.5 && p.x <= 2.5 && p.y >= 1.5 && p.y <= 2.5;
}

/// Of the floor, around the box.
bool IsInBorderOfShadow(const glm::dvec3& p)
{
  return p.z == 0.0 && p.x >= 1.0 && p.x <= 3.0 && p.y >= 1.0 && p.y <= 3.0 && !IsUnderBox(p);
}

const Part Parts[] = { { "faces",
                         [](const glm::dvec3& p) { return Borders(p) == 1 && !IsUnderBox(p); } },
  { "edges", [](const glm::dvec3& p) { return Borders(p) == 2; } },
  { "corners", [](const glm::dvec3& p) { return Borders(p) == 3; } },
  { "shadow", IsInBorderOfShadow } };

std::vector<double> Chosen(
  const std::vector<double>& values, const Surface& surface, const Part& part)
{
  std::vector<double> chosen;
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (part.counts(surface.points[p]))
    {
      chosen.push_back(values[p]);
    }
  }
  return chosen;
}

} // namespace

// That there is no bias is tested elsewhere: here the mean of all seeds stands for the truth.
TEST(FinalGathering, ErrorIsWhatTheStandardErrorSays)
{
  const Surface surface = RoomWithBox();
  const Scene scene(surface);
  const RectangleLamp panel{ { 2.2, 1.8, 2.9 }, { 0, 0, -1 }, 1.0, 1.0, 3000.0 };
  std::vector<std::vector<double>> values[std::size(Parts)], errors[std::size(Parts)];
  for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
  {
    const IlluminationMap map = GatheredFront(scene, panel, GatheringSettings(256, seed), 50'000);
    for (std::size_t i = 0; i < std::size(Parts); ++i)
    {
      values[i].push_back(Chosen(Total(map), surface, Parts[i]));
      errors[i].push_back(Chosen(map.standardError, surface, Parts[i]));
    }
  }
  for (std::size_t i = 0; i < std::size(Parts); ++i)
  {
    const ToldErrors told = CompareWithTold(values[i], errors[i], {});
    std::printf(
      "  %-8s %3zu points: mean of (error/SE)^2 %.3f +- %.3f, 95 %% interval covers %.1f %%\n",
      Parts[i].name, values[i][0].size(), told.square.mean, told.square.error,
      100.0 * told.covered);
    RecordProperty(Parts[i].name, std::to_string(told.square.mean));
    // Photons of eight replicates tell their noise as Student's t of seven degrees of freedom does,
    // whose square has the mean 7/5. That of rays is known from many of them: 1. It is told from
    // rays that are independent, but they are spread evenly, and err less: down to 0.8.
    EXPECT_GT(told.square.mean, 0.8 - 3.0 * told.square.error) << Parts[i].name;
    EXPECT_LT(told.square.mean, 1.4 + 3.0 * told.square.error) << Parts[i].name;
    EXPECT_GT(told.covered, 0.93) << Parts[i].name;
  }
}
