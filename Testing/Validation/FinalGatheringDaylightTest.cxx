// SPDX-License-Identifier: BSD-3-Clause
// The second pass and daylight: the cases of CIE 171:2006 with a hundredth of the photons, at
// single points. They are told of openings, or not.
#include "GatheringTools.h"
#include "References.h"
#include "Shapes.h"
#include "ValidationCase.h"

#include "PhotonTransport/transport/SkyOpenings.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace PhotonTransport;
using References::Rectangle;

namespace
{

constexpr double Half = 2.0;   ///< m, half the room's side.
constexpr double Height = 3.0; ///< m
constexpr float Glass = 1.52f;

const Rectangle RoofOpening{ { -1, -1, Height }, { 2, 0, 0 }, { 0, 2, 0 } };
const Rectangle NoRoof{ { -Half, -Half, Height }, { 2 * Half, 0, 0 }, { 0, 2 * Half, 0 } };
const Rectangle Window{ { -1, Half, 1 }, { 2, 0, 0 }, { 0, 0, 1 } };

/// Out of sight of the floor, so that the cusp of the sky's luminance does not disturb the
/// quadrature; for a window it is to one side.
const glm::dvec3 Sun = glm::normalize(glm::dvec3(0.1, -1.5, 1.0));
const glm::dvec3 SideSun = glm::normalize(glm::dvec3(1.0, 0.5, 0.4));

Surface RoomWithRoofOpening()
{
  return Shapes::OpenRoom(2.0 * Half, Height, { -1.0, -1.0, 1.0, 1.0 }, 4);
}

Surface RoomWithWindow()
{
  return Shapes::RoomWithWindow(2.0 * Half, Height, { -1.0, 1.0, 1.0, 2.0 }, 4);
}

Surface WithPane(const Surface& room, const Rectangle& opening)
{
  Surface both = Shapes::Together(room, Shapes::Rectangle(opening.corner, opening.u, opening.v, 1));
  Material glass;
  glass.clearTransmittance = Colour(1.0f);
  glass.refractiveIndex = Glass;
  const Material wall = room.materials.empty() ? Material() : room.materials.front();
  both.materials = { wall, glass };
  both.materialOfFacet.assign(both.facets.size(), 1);
  std::fill_n(both.materialOfFacet.begin(), room.facets.size(), 0u);
  return both;
}

/// What an opening and a sky send to a point of a floor.
struct Daylight
{
  Rectangle opening;
  References::Luminance sky;
  double index = 1.0; ///< Of a pane in the opening.
  /// How far in v the opening sees the sky; all of it if empty.
  std::function<double(const glm::dvec3& point)> end{};

  double At(const glm::dvec3& point) const
  {
    const glm::dvec3 area = glm::cross(this->opening.u, this->opening.v);
    const auto from = [&](double s, double t)
    {
      const glm::dvec3 ray =
        this->opening.corner + s * this->opening.u + t * this->opening.v - point;
      const double d = glm::length(ray);
      const double cosine = std::fabs(glm::dot(ray, glm::normalize(area))) / d;
      const double sheet =
        this->index > 1.0 ? References::SheetTransmittance(cosine, this->index) : 1.0;
      return this->sky(ray / d) * sheet * cosine * glm::length(area) * ray.z / (d * d * d);
    };
    const double last = this->end ? std::clamp(this->end(point), 0.0, 1.0) : 1.0;
    return References::Integral([&](double t)
      { return References::Integral([&](double s) { return from(s, t); }, 0.0, 1.0); },
      0.0, last);
  }

  /// Of the light at the points of the floor: its sum, and its moments along both sides.
  std::vector<Quantity> OnFloor(const Surface& room) const
  {
    const std::vector<double> none(room.points.size(), 0.0);
    std::vector<Quantity> quantities(3, Quantity{ 0.0, none });
    for (std::size_t p = 0; p < room.points.size(); ++p)
    {
      if (room.normals[p].z > 0.5 && room.points[p].z == 0.0)
      {
        const double lux = this->At(room.points[p]);
        const double weights[3] = { 1.0, room.points[p].x + Half, Half - room.points[p].y };
        for (std::size_t q = 0; q < 3; ++q)
        {
          quantities[q].weights[p] = weights[q];
          quantities[q].exact += weights[q] * lux;
        }
      }
    }
    return quantities;
  }
};

/// Final gathering with so many photons in all.
void ExpectDaylight(const std::string& name, const Surface& room, const Lighting& sky,
  const Daylight& daylight, double photons, bool withoutOpenings = false)
{
  ValidationCase known{ name + ", final gathering", room, sky, daylight.OnFloor(room), photons };
  known.settings = GatheringSettings(withoutOpenings ? 1024 : 256);
  known.withoutOpenings = withoutOpenings;
  ExpectExact(known);
}

class GatheredSky : public testing::TestWithParam<int>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(FinalGathering, GatheredSky, testing::Values(1, 5, 12, 16),
  [](const auto& instance) { return "Type" + std::to_string(instance.param); });

TEST_P(GatheredSky, ThroughRoofs)
{
  const int type = GetParam();
  const CieSky sky{ { 0, 0, 1 }, type, Sun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(type, Sun, 10'000.0);
  const std::string number = ", CIE sky " + std::to_string(type);
  const Surface room = RoomWithRoofOpening();
  ExpectDaylight("5.9 roof opening" + number, room, sky, { RoofOpening, luminance }, 6e4);
  ExpectDaylight("5.10 roof opening with glass" + number, WithPane(room, RoofOpening), sky,
    { RoofOpening, luminance, Glass }, 4e4);
  const Surface open = Shapes::OpenRoom(2.0 * Half, Height, { -Half, -Half, Half, Half }, 4);
  ExpectDaylight("5.9 no roof" + number, open, sky, { NoRoof, luminance }, 1e4);
  ExpectDaylight(
    "5.10 roof of glass" + number, WithPane(open, NoRoof), sky, { NoRoof, luminance, Glass }, 1e4);
}

TEST_P(GatheredSky, ThroughAWindow)
{
  const int type = GetParam();
  const CieSky sky{ { 0, 0, 1 }, type, SideSun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(type, SideSun, 10'000.0);
  const std::string number = ", CIE sky " + std::to_string(type);
  ExpectDaylight("5.11 window" + number, RoomWithWindow(), sky, { Window, luminance }, 8e4);
  ExpectDaylight("5.12 window with glass" + number, WithPane(RoomWithWindow(), Window), sky,
    { Window, luminance, Glass }, 8e4);
  // See Facade in Cie171SkyTest.
  constexpr double Depth = 0.5, Sill = 1.0, Top = 2.0;
  const Surface overhang = Shapes::Rectangle({ -4, Half, Top }, { 8, 0, 0 }, { 0, Depth, 0 }, 1);
  const auto end = [](const glm::dvec3& p)
  { return (Top * (Half - p.y) / (Half + Depth - p.y) - Sill) / (Top - Sill); };
  ExpectDaylight("5.13 window with glass and overhang" + number,
    WithPane(Shapes::Together(RoomWithWindow(), overhang), Window), sky,
    { Window, luminance, Glass, end }, 2e5);
}

TEST(FinalGathering, DaylightIsTheSameWithoutOpeningsBeingKnown)
{
  const CieSky sky{ { 0, 0, 1 }, 16, Sun, 10'000.0 };
  const auto luminance = References::CieSkyLuminance(16, Sun, 10'000.0);
  ExpectDaylight("5.9 roof opening that is not known, CIE sky 16", RoomWithRoofOpening(), sky,
    { RoofOpening, luminance }, 6e4, true);
}

namespace
{

/// [seed][vertex] lx, in a reflecting room with glass in its window and ground before it.
struct RoomAndGround
{
  std::vector<std::vector<double>> values, errors;

  RoomAndGround(const Surface& surface, bool withOpenings)
  {
    constexpr std::uint32_t Seeds = 16;
    const UniformSky sky{ { 0, 0, 1 }, 10'000.0, false };
    const Scene scene(surface);
    for (std::uint32_t seed = 1; seed <= Seeds; ++seed)
    {
      const TraceSettings settings =
        GatheringSettings(withOpenings ? 256 : 512, seed + (withOpenings ? 0 : 100));
      const Openings openings =
        withOpenings ? OpeningsToSkies(surface, scene, sky, settings).openings : Openings();
      EXPECT_EQ(openings.IsEmpty(), !withOpenings);
      const IlluminationMap map = GatheredFront(scene, sky, settings, 20'000, openings);
      this->values.push_back(map.direct);
      this->errors.push_back(map.standardError);
      std::transform(map.direct.begin(), map.direct.end(), map.indirect.begin(),
        this->values.back().begin(), std::plus<>());
    }
  }

  /// The mean over the vertices in- or outdoors, and its error by the seeds.
  MeanAndError Mean(const Surface& surface, bool outdoors) const
  {
    std::vector<double> means;
    for (const std::vector<double>& seed : this->values)
    {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t p = 0; p < seed.size(); ++p)
      {
        const bool counts = (surface.points[p].y > Half) == outdoors;
        sum += counts ? seed[p] : 0.0;
        count += counts;
      }
      means.push_back(sum / count);
    }
    return MeanOf(means);
  }
};

} // namespace

// Matt walls and ground: the light has no closed form, but is the same both ways, out of doors too.
// At a single point light that few rays find has so skew a distribution that its error is often
// told too small; hence means over all points.
TEST(FinalGathering, OpeningsChangeNoiseAlone)
{
  const Surface ground = Shapes::Rectangle({ -2, Half, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 4);
  const Surface surface =
    WithPane(Shapes::WithReflectance(Shapes::Together(RoomWithWindow(), ground), 0.5f), Window);
  const RoomAndGround with(surface, true);
  const RoomAndGround without(surface, false);
  for (const bool outdoors : { false, true })
  {
    const MeanAndError a = with.Mean(surface, outdoors);
    const MeanAndError b = without.Mean(surface, outdoors);
    std::printf("  %s %.1f +- %.1f lx with openings, %.1f +- %.1f without\n",
      outdoors ? "outdoors" : "indoors ", a.mean, a.error, b.mean, b.error);
    EXPECT_LT(std::fabs(a.mean - b.mean), 4.0 * std::hypot(a.error, b.error));
    EXPECT_LT(a.error, 0.01 * a.mean);
  }
}

// Black ground before a black house: E = pi L (1 - F), F the factor to the wall.
TEST(FinalGathering, GroundOutdoorsHasTheSkyThatAHouseLeaves)
{
  const Surface ground = Shapes::Rectangle({ -2, Half, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 4);
  const Surface surface = Shapes::Together(RoomWithWindow(), ground);
  const RoomAndGround with(surface, true);
  std::vector<std::vector<double>> values, errors;
  std::vector<double> exact;
  for (std::size_t seed = 0; seed < with.values.size(); ++seed)
  {
    values.emplace_back();
    errors.emplace_back();
    exact.clear();
    for (std::size_t p = 0; p < surface.points.size(); ++p)
    {
      if (surface.points[p].y > Half)
      {
        values.back().push_back(with.values[seed][p]);
        errors.back().push_back(with.errors[seed][p]);
        exact.push_back(References::Pi * 10'000.0 *
          (1.0 -
            References::ConfigurationFactor(surface.points[p], { 0, 0, 1 },
              { { -Half, Half, 0 }, { Half, Half, 0 }, { Half, Half, Height },
                { -Half, Half, Height } })));
      }
    }
  }
  ASSERT_EQ(exact.size(), 20u);
  const ToldErrors told = CompareWithTold(values, errors, exact);
  std::printf("  mean of (error/SE)^2 %.3f +- %.3f, largest mean %.2f\n", told.square.mean,
    told.square.error, told.largest);
  EXPECT_LT(told.square.mean, 1.4 + 3.0 * told.square.error);
  EXPECT_LT(told.largest, 4.0);
}
