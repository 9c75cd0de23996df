// SPDX-License-Identifier: BSD-3-Clause
// Cases of CIE 171:2006 with daylight: black rooms, so that all light comes straight through an
// opening, under the sky. Photons start at the openings, or, with many more, over the whole scene.
#include "References.h"
#include "Shapes.h"
#include "ValidationCase.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

using namespace PhotonTransport;
using References::Rectangle;

namespace
{

constexpr double Half = 2.0;   ///< m, half the room's side.
constexpr double Height = 3.0; ///< m
constexpr float Glass = 1.52f;

const Rectangle Floor{ { -Half, -Half, 0 }, { 2 * Half, 0, 0 }, { 0, 2 * Half, 0 } };
const Rectangle Wall{ { Half, -Half, 0 }, { 0, 0, Height }, { 0, 2 * Half, 0 } }; ///< Facing -x.

/// Seen from no point of floor and wall through the roof, so that the cusp of the sky's luminance
/// does not disturb the quadrature: behind the wall, and lower than any light that comes by the
/// roof to the floor, |y| / z <= 4 / 3.
const glm::dvec3 Sun = glm::normalize(glm::dvec3(0.1, -1.5, 1.0));
/// Before the window, to one side; what little of the floor sees it costs the quadrature 5e-7.
const glm::dvec3 SideSun = glm::normalize(glm::dvec3(1.0, 0.5, 0.4));

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

/// The flux on a part of the room and two moments of its light: of the coordinates that are 0 and 1
/// on the part's edges along u, and 1 and 0 along v.
struct Receiver
{
  Rectangle part;
  Rectangle lit; ///< The light falls within.
  std::function<double(const glm::dvec3&)> end{};

  explicit Receiver(const Rectangle& whole)
    : part(whole)
    , lit(whole)
  {
  }

  std::vector<Quantity> Quantities(const Surface& room, const Rectangle& opening,
    const References::Luminance& sky, double index) const
  {
    const auto along = [](const glm::dvec3& p, const glm::dvec3& corner, const glm::dvec3& side)
    { return glm::dot(p - corner, side) / glm::dot(side, side); };
    const std::function<double(const glm::dvec3&)> moments[] = { [](const glm::dvec3&)
      { return 1.0; },
      [&](const glm::dvec3& p) { return along(p, this->part.corner, this->part.u); },
      [&](const glm::dvec3& p) { return 1.0 - along(p, this->part.corner, this->part.v); } };
    const glm::dvec3 normal = glm::normalize(glm::cross(this->part.u, this->part.v));
    std::vector<bool> counts;
    for (std::size_t p = 0; p < room.points.size(); ++p)
    {
      counts.push_back(glm::dot(room.points[p] - this->part.corner, normal) == 0.0 &&
        glm::dot(room.normals[p], normal) > 0.5);
    }
    std::vector<Quantity> quantities;
    for (const auto& g : moments)
    {
      std::vector<double> values;
      std::transform(room.points.begin(), room.points.end(), std::back_inserter(values), g);
      quantities.push_back(
        { References::ReceiverIntegral(this->lit, opening, sky, index, g, this->end),
          IntegralWeights(room, counts, values) });
    }
    return quantities;
  }
};

std::vector<Quantity> OfFloorAndWall(
  const Surface& room, const Rectangle& opening, const References::Luminance& sky, double index)
{
  std::vector<Quantity> quantities = Receiver(Floor).Quantities(room, opening, sky, index);
  const std::vector<Quantity> wall = Receiver(Wall).Quantities(room, opening, sky, index);
  quantities.insert(quantities.end(), wall.begin(), wall.end());
  return quantities;
}

Surface Pane(const Rectangle& opening)
{
  return Shapes::Rectangle(opening.corner, opening.u, opening.v, 1);
}

/// Photons of all runs: through openings that are found, and over the whole scene.
struct PhotonNumbers
{
  double throughOpenings, overAll;
};

/// Through openings; in two of the skies also without them.
void ExpectDaylight(const std::string& name, int type, const Surface& room, const CieSky& sky,
  const std::vector<Quantity>& quantities, const PhotonNumbers& photons)
{
  const std::string number = ", CIE sky " + std::to_string(type);
  ExpectExact({ name + number, room, sky, quantities, photons.throughOpenings });
  if (type == 1 || type == 12)
  {
    ValidationCase known{ name + " that is not known" + number, room, sky, quantities,
      photons.overAll };
    known.withoutOpenings = true;
    ExpectExact(known);
  }
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
  const Rectangle opening{ { -1, -1, Height }, { 2, 0, 0 }, { 0, 2, 0 } };
  const Surface room = Shapes::OpenRoom(2.0 * Half, Height, { -1.0, -1.0, 1.0, 1.0 }, 4);
  const CieSky sky{ { 0, 0, 1 }, type, Sun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(type, Sun, 10'000.0);
  ExpectDaylight("5.9 roof opening", type, room, sky, OfFloorAndWall(room, opening, luminance, 1.0),
    { 2.5e5, 6e6 });
  const Surface glazed = WithGlass(room, Pane(opening));
  ExpectDaylight("5.10 roof opening with glass", type, glazed, sky,
    Receiver(Floor).Quantities(glazed, opening, luminance, Glass), { 2e5, 4e6 });
}

TEST_P(EverySky, WithoutARoof)
{
  const int type = GetParam();
  const Rectangle opening{ { -Half, -Half, Height }, Floor.u, Floor.v };
  const Surface room = Shapes::OpenRoom(2.0 * Half, Height, { -Half, -Half, Half, Half }, 4);
  const CieSky sky{ { 0, 0, 1 }, type, Sun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(type, Sun, 10'000.0);
  const Receiver floor(Floor);
  ExpectDaylight("5.9 no roof", type, room, sky, floor.Quantities(room, opening, luminance, 1.0),
    { 2.5e5, 1e6 });
  const Surface glazed = WithGlass(room, Pane(opening));
  ExpectDaylight("5.10 roof of glass", type, glazed, sky,
    floor.Quantities(glazed, opening, luminance, Glass), { 2.5e5, 1e6 });
}

// A window in the wall y = 2, with glass, without and with a black overhang at its upper edge.
class Facade : public testing::TestWithParam<int>
{
protected:
  static constexpr double Sill = 1.0, Top = 2.0;
  static constexpr double Depth = 0.5;
  const Rectangle Window{ { -1.0, Half, Sill }, { 2, 0, 0 }, { 0, 0, Top - Sill } };
  Surface Room = Shapes::RoomWithWindow(2.0 * Half, Height, { -1.0, Sill, 1.0, Top }, 4);
  const CieSky Sky{ { 0, 0, 1 }, GetParam(), SideSun, 10'000.0 };
  const References::Luminance Luminance =
    References::CieSkyLuminance(GetParam(), SideSun, 10'000.0);
};
INSTANTIATE_TEST_SUITE_P(Cie171, Facade, testing::Values(1, 12),
  [](const auto& instance) { return "Type" + std::to_string(instance.param); });

TEST_P(Facade, WithGlass)
{
  const Surface room = WithGlass(this->Room, Pane(this->Window));
  ExpectDaylight("5.12 window with glass", GetParam(), room, this->Sky,
    Receiver(Floor).Quantities(room, this->Window, this->Luminance, Glass), { 8e4, 8e6 });
}

TEST_P(Facade, WithGlassAndOverhang)
{
  // Wide enough that no light comes past its ends: from (-+2, y) through the far edge of the window
  // a ray meets the overhang's height at most 4 m from the middle.
  const Surface overhang = Shapes::Rectangle({ -4, Half, Top }, { 8, 0, 0 }, { 0, Depth, 0 }, 1);
  const Surface room = WithGlass(Shapes::Together(this->Room, overhang), Pane(this->Window));
  // A ray from (x, y, 0) through the window at height z is at the overhang's height where it has
  // gone (2 - y) Top / z; it sees the sky if that is beyond the overhang's edge, at 2 + Depth.
  // Where even the sill is too high for that, the floor is dark.
  Receiver floor(Floor);
  floor.end = [&](const glm::dvec3& p)
  { return (Top * (Half - p.y) / (Half + Depth - p.y) - Sill) / (Top - Sill); };
  const double lastLit = Half - Sill * Depth / (Top - Sill);
  floor.lit.v = { 0, lastLit + Half, 0 };
  ExpectDaylight("5.13 window with glass and overhang", GetParam(), room, this->Sky,
    floor.Quantities(room, this->Window, this->Luminance, Glass), { 2e5, 2e7 });
}
