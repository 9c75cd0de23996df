// SPDX-License-Identifier: BSD-3-Clause
// Cases of CIE 171:2006 with daylight: black rooms, so that all light comes straight through an
// opening, under the sky.
#include "References.h"
#include "Shapes.h"
#include "ValidationCase.h"

#include "PhotonTransport/lights/CieSkyLuminance.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace PhotonTransport;
using References::Opening;

namespace
{

constexpr double Half = 2.0;   ///< m, half the room's side.
constexpr double Height = 3.0; ///< m
constexpr float Glass = 1.52f;

/// Seen from no point of the floor through the openings, so that the cusp of the sky's luminance
/// does not disturb the quadrature.
const glm::dvec3 Sun = glm::normalize(glm::dvec3(1.0, -0.5, 0.4));

/// All of it a black surface, but for its last facets, which are clear glass.
Surface WithGlass(const Surface& black, const Surface& pane)
{
  Surface both = Shapes::Together(black, pane);
  Material glass;
  glass.clearTransmittance = Colour(1.0f);
  glass.refractiveIndex = Glass;
  both.materials = { Material(), glass };
  both.materialOfFacet.assign(both.facets.size(), 1);
  std::fill_n(both.materialOfFacet.begin(), black.facets.size(), 0u);
  return both;
}

/// The floor's flux and two moments of its light: linear functions of x and y that are never
/// negative.
std::vector<Quantity> OfTheFloor(const Surface& room, const Opening& opening,
  const References::Luminance& sky, double index,
  const std::function<double(double)>& upperEnd = {}, double lastLit = 1e9)
{
  std::vector<bool> floor;
  for (std::size_t p = 0; p < room.points.size(); ++p)
  {
    floor.push_back(room.points[p].z == 0.0 && room.normals[p].z > 0.5);
  }
  const std::function<double(double, double)> moments[] = { [](double, double) { return 1.0; },
    [](double x, double) { return 1.0 + x / Half; },
    [](double, double y) { return 1.0 - y / Half; } };
  std::vector<Quantity> quantities;
  for (const auto& g : moments)
  {
    std::vector<double> values;
    for (const glm::dvec3& p : room.points)
    {
      values.push_back(g(p.x, p.y));
    }
    quantities.push_back(
      { References::FloorIntegral(Half, opening, sky, index, g, upperEnd, lastLit),
        IntegralWeights(room, floor, values) });
  }
  return quantities;
}

class EverySky : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(Cie171, EverySky, testing::Range(1, 17),
  [](const auto& instance) { return "Type" + std::to_string(instance.param); });

} // namespace

TEST_P(EverySky, ThroughARoofOpening)
{
  const int type = GetParam();
  const Opening opening{ -1.0, 1.0, -1.0, 1.0, Height };
  const Surface room = Shapes::OpenRoom(2.0 * Half, Height, { -1.0, -1.0, 1.0, 1.0 }, 4);
  const CieSky sky{ { 0, 0, 1 }, type, Sun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(type, Sun, 10'000.0);
  const std::string number = ", CIE sky " + std::to_string(type);
  ExpectExact(
    { "5.9 roof opening" + number, room, sky, OfTheFloor(room, opening, luminance, 1.0), 5e6 });
  const Surface glazed =
    WithGlass(room, Shapes::Rectangle({ -1, -1, Height }, { 2, 0, 0 }, { 0, 2, 0 }, 1));
  ExpectExact({ "5.10 roof opening with glass" + number, glazed, sky,
    OfTheFloor(glazed, opening, luminance, Glass), 5e6 });
}

TEST_P(EverySky, IsOneAtTheZenithAndLightEverywhere)
{
  const int type = GetParam();
  const double sunAngle = std::acos(Sun.z);
  EXPECT_NEAR(RelativeSkyLuminance(type, 0.0, sunAngle, sunAngle), 1.0, 1e-12);
  for (double zenith = 0.0; zenith <= 0.5 * References::Pi; zenith += 0.01)
  {
    for (double azimuth = 0.0; azimuth < References::Pi; azimuth += 0.1)
    {
      const double cosine = std::cos(zenith) * std::cos(sunAngle) +
        std::sin(zenith) * std::sin(sunAngle) * std::cos(azimuth);
      const double luminance =
        RelativeSkyLuminance(type, zenith, sunAngle, std::acos(std::min(1.0, cosine)));
      EXPECT_GT(luminance, 0.0);
      if (type == 5)
      {
        EXPECT_DOUBLE_EQ(luminance, 1.0); // the uniform one
      }
    }
  }
}

// A window in the wall y = 2, with glass, without and with a black overhang of 1 m at its upper
// edge.
class Facade : public testing::TestWithParam<int>
{
protected:
  static constexpr double Top = 2.0;
  static constexpr double Depth = 1.0;
  const Opening Window{ -1.0, 1.0, 1.0, Top, Half, true };
  Surface Room = Shapes::RoomWithWindow(2.0 * Half, Height, { -1.0, 1.0, 1.0, Top }, 4);
  Surface Pane = Shapes::Rectangle({ -1, Half, 1 }, { 2, 0, 0 }, { 0, 0, Top - 1.0 }, 1);
};
INSTANTIATE_TEST_SUITE_P(Cie171, Facade, testing::Values(1, 5, 12),
  [](const auto& instance) { return "Type" + std::to_string(instance.param); });

TEST_P(Facade, WithGlass)
{
  const auto luminance = References::CieSkyLuminance(GetParam(), Sun, 10'000.0);
  const Surface room = WithGlass(this->Room, this->Pane);
  ExpectExact({ "5.12 window with glass, CIE sky " + std::to_string(GetParam()), room,
    CieSky{ { 0, 0, 1 }, GetParam(), Sun, 10'000.0 },
    OfTheFloor(room, this->Window, luminance, Glass), 8e6 });
}

TEST_P(Facade, WithGlassAndOverhang)
{
  const auto luminance = References::CieSkyLuminance(GetParam(), Sun, 10'000.0);
  // Wide enough that no light comes past its ends: from (-+2, y) through the far edge of the window
  // a ray meets the overhang's height at most 4 m from the middle.
  const Surface overhang = Shapes::Rectangle({ -4, Half, Top }, { 8, 0, 0 }, { 0, Depth, 0 }, 1);
  const Surface room = WithGlass(Shapes::Together(this->Room, overhang), this->Pane);
  // A ray from (x, y, 0) through the window at height v is at the overhang's height where it has
  // gone (2 - y) Top / v; it sees the sky if that is beyond the overhang's edge.
  // Of the floor beyond y = 1 that part is below the window.
  const auto upperEnd = [&](double y) { return Top * (Half - y) / (Half + Depth - y); };
  ExpectExact({ "5.13 window with glass and overhang, CIE sky " + std::to_string(GetParam()), room,
    CieSky{ { 0, 0, 1 }, GetParam(), Sun, 10'000.0 },
    OfTheFloor(room, this->Window, luminance, Glass, upperEnd, 1.0), 24e6 });
}
