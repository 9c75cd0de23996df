// SPDX-License-Identifier: BSD-3-Clause
// Lamps that touch surfaces: all their light goes to the side to which they shine.
#include "CoreTools.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Lumens = 1000.0;
constexpr std::uint64_t Photons = 20'000;

/// A motion of the whole model: a turn about a skew axis, and a shift.
struct Motion
{
  double angle = 0.0; ///< Radians.
  glm::dvec3 shift{ 0.0 };

  glm::dvec3 Direction(const glm::dvec3& v) const
  {
    const glm::dvec3 k = glm::normalize(glm::dvec3(0.3, -0.5, 0.8)); // Rodrigues' formula
    return v * std::cos(this->angle) + glm::cross(k, v) * std::sin(this->angle) +
      k * glm::dot(k, v) * (1.0 - std::cos(this->angle));
  }
  glm::dvec3 Point(const glm::dvec3& p) const { return this->Direction(p) + this->shift; }
};

Surface Moved(Surface surface, const Motion& motion)
{
  for (glm::dvec3& point : surface.points)
  {
    point = motion.Point(point);
  }
  for (glm::dvec3& normal : surface.normals)
  {
    normal = motion.Direction(normal);
  }
  return surface;
}

constexpr glm::dvec3 Low{ 0.0, 0.0, 0.0 }, High{ 4.2, 5.1, 2.7 };

/// cos(gamma) below the horizon and dark above it.
PhotometricSolid LambertianSolid()
{
  PhotometricSolid solid;
  solid.azimuth = { 0.0, 360.0 };
  for (int gamma = 0; gamma <= 180; gamma += 2)
  {
    solid.polar.push_back(gamma);
    solid.candela.push_back(gamma < 90 ? std::cos(glm::radians(1.0 * gamma)) * 318.0 : 0.0);
  }
  const std::vector<double> other = solid.candela;
  solid.candela.insert(solid.candela.end(), other.begin(), other.end());
  return solid;
}

/// Every kind of lamp that has a place, there and aiming that way.
std::vector<Lamp> LampsAt(const glm::dvec3& place, const glm::dvec3& aim)
{
  EmittingMesh mesh;
  const glm::dvec3 across = glm::normalize(
    glm::cross(aim, std::fabs(aim.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
  const glm::dvec3 other = glm::cross(aim, across);
  mesh.points = { place - 0.1 * across - 0.1 * other, place + 0.2 * across, place + 0.2 * other };
  mesh.facets = { { 0, 1, 2 } };
  mesh.exitance = { 1e4f };
  return { PointLamp{ place, Lumens }, LambertianPointLamp{ place, aim, Lumens },
    SpotLamp{ place, aim, 0.9, 2.0, Lumens }, SpotLamp{ place, aim, 0.5, 0.0, Lumens },
    RectangleLamp{ place, aim, 0.6, 0.3, Lumens }, DiskLamp{ place, aim, 0.1, Lumens },
    DiskLamp{ place, aim, 0.0, Lumens }, PhotometricLamp{ place, aim, 0.3, LambertianSolid() },
    mesh };
}

const double Turns[] = { 0.0, 10.0, 30.0, 37.0, 45.0, 123.0 }; // degrees

Motion Turned(double degrees, double shift = 0.0)
{
  return { glm::radians(degrees), glm::dvec3(shift) };
}

class LampPlace : public ::testing::Test
{
protected:
  /// The room after a motion.
  static Surface Room(const Motion& motion)
  {
    return Moved(Shapes::Box(Low, High, 4, Facing::Inward), motion);
  }

  /// Calls f(lamp) for every kind of lamp at a place of the model, after its motion.
  template <class Function>
  void ForEachLamp(
    const Motion& motion, const glm::dvec3& place, const glm::dvec3& aim, const Function& f)
  {
    for (const Lamp& lamp : LampsAt(motion.Point(place), motion.Direction(aim)))
    {
      SCOPED_TRACE(std::to_string(glm::degrees(motion.angle)) + " degrees, moved by " +
        std::to_string(motion.shift.x) + ", lamp " + std::to_string(lamp.index()));
      f(lamp);
    }
  }

  /// All photons must arrive at fronts, and none escape.
  void ExpectAllOnFronts(const Surface& surface, const Lamp& lamp)
  {
    TraceSettings settings;
    settings.registerBackSide = true;
    settings.registration = Registration::Flat;
    const TracedMap run(surface, lamp, settings, Photons);
    EXPECT_EQ(run.balance.escaped, 0u);
    EXPECT_NEAR(run.RegisteredFlux(run.front), run.flux, 1e-6 * run.flux);
    EXPECT_EQ(run.RegisteredFlux(run.back), 0.0);
    ++this->Lamps;
  }

  void ReportLamps(const std::string& protects, const std::string& where)
  {
    Report(protects, std::to_string(this->Lamps) + " lamps " + where + ": all light on fronts");
  }

  int Lamps = 0;
};

} // namespace

TEST_F(LampPlace, RecessedLampsLightTheRoom)
{
  for (const double degrees : Turns)
  {
    for (const double shift : { 0.0, 1e3 / 3.0, 1e6 / 3.0 })
    {
      const Motion motion = Turned(degrees, shift);
      const Surface room = this->Room(motion);
      this->ForEachLamp(motion, { 1.3, 1.9, High.z }, { 0, 0, -1 },
        [&](const Lamp& lamp) { this->ExpectAllOnFronts(room, lamp); });
    }
  }
  this->ReportLamps("recessed lamps, whose light rounding puts on the ceiling's back",
    "of all kinds in turned rooms");
}

TEST_F(LampPlace, OnEveryWallEdgeCornerAndVertex)
{
  for (const double degrees : { 0.0, 37.0 })
  {
    const Motion motion = Turned(degrees);
    const Surface room = this->Room(motion);
    for (int at = 0; at < 27; ++at)
    {
      const glm::ivec3 side(at % 3, at / 3 % 3, at / 9);
      const glm::dvec3 middle = 0.5 * (Low + High); // a vertex of the walls' mesh
      glm::dvec3 place, inwards(0.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] = side[axis] == 0 ? Low[axis] : side[axis] == 1 ? middle[axis] : High[axis];
        inwards[axis] = 1.0 - side[axis];
      }
      if (at == 13)
      {
        inwards = { 0, 0, -1 }; // in the middle of the room
      }
      SCOPED_TRACE(std::to_string(degrees) + " degrees, place " + std::to_string(at));
      const glm::dvec3 where = motion.Point(place);
      this->ExpectAllOnFronts(room, PointLamp{ where, Lumens });
      const glm::dvec3 aim = glm::normalize(motion.Direction(inwards));
      this->ExpectAllOnFronts(room, LambertianPointLamp{ where, aim, Lumens });
      this->ExpectAllOnFronts(room, SpotLamp{ where, aim, 0.6, 0.0, Lumens });
      this->ExpectAllOnFronts(room, SphereLamp{ where, 0.0, Lumens });
    }
  }
  this->ReportLamps(
    "lamps that touch several surfaces at once", "on every wall, edge, corner and in the middle");
}

// The edge of a room under a roof as flat as one degree: both walls lie close behind such a lamp.
TEST_F(LampPlace, InAcuteEdges)
{
  for (const double degrees : { 0.0, 37.0, 123.0 })
  {
    for (const double wedge : { 10.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0 })
    {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, wedge of " + std::to_string(wedge));
      const Motion motion = Turned(degrees, degrees / 30.0);
      const Surface room = Moved(Shapes::Wedge(wedge, Facing::Inward), motion);
      const double half = glm::radians(0.5 * wedge);
      const glm::dvec3 aim = motion.Direction({ std::cos(half), std::sin(half), 0.0 });
      for (const double z : { 0.5, 0.3, 0.0 })
      {
        const glm::dvec3 place = motion.Point({ 0.0, 0.0, z });
        this->ExpectAllOnFronts(room, PointLamp{ place, Lumens });
        this->ExpectAllOnFronts(room, LambertianPointLamp{ place, aim, Lumens });
        this->ExpectAllOnFronts(room, SpotLamp{ place, aim, 0.3 * half, 0.0, Lumens });
      }
      const glm::dvec3 middle = motion.Point({ 0.0, 0.0, 0.5 });
      this->ExpectAllOnFronts(room, LineLamp{ middle, motion.Direction({ 0, 0, 1 }), 0.4, Lumens });
    }
  }
  this->ReportLamps("lamps between walls that meet at 1 to 10 degrees", "in acute edges");
}

// A tube in the edge of ceiling and wall, and one across the ceiling: in front of both.
TEST_F(LampPlace, TubesOnWallsAndEdges)
{
  for (const double degrees : Turns)
  {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    const Motion motion = Turned(degrees);
    const Surface room = this->Room(motion);
    for (const glm::dvec3& centre :
      { glm::dvec3(2.0, 2.5, High.z), glm::dvec3(2.0, 0.0, High.z), glm::dvec3(2.0, 0.0, 0.0) })
    {
      this->ExpectAllOnFronts(
        room, LineLamp{ motion.Point(centre), motion.Direction({ 1, 0, 0 }), 1.2, Lumens });
    }
  }
  this->ReportLamps("tubes that touch walls along their length", "on ceilings and in edges");
}

// Within rounding a lamp is in the ceiling, on either side of it; in front of it, it is where it
// is.
TEST_F(LampPlace, JustBesideTheCeiling)
{
  for (const double degrees : Turns)
  {
    const Motion motion = Turned(degrees);
    const Surface room = this->Room(motion);
    for (const double behind : { 1e-9, 1e-8, 1e-7, 1e-6, -1e-9, -1e-8, -1e-7, -1e-6, -1e-5, -1e-4,
           -1e-3 }) // of the room's size
    {
      SCOPED_TRACE(std::to_string(behind * 1e9) + "e-9 behind");
      this->ForEachLamp(motion, { 1.3, 1.9, High.z + behind * High.y }, { 0, 0, -1 },
        [&](const Lamp& lamp) { this->ExpectAllOnFronts(room, lamp); });
    }
  }
  this->ReportLamps("lamps that rounding has put behind the ceiling",
    "from 1e-6 of the room behind to 1e-3 before the ceiling");
}

// Far behind the ceiling a lamp shines on its back, as it would. This has always held, and lamps
// that are moved must not change it.
TEST_F(LampPlace, BehindTheCeilingItStaysDark)
{
  const Surface room = Shapes::Box(Low, High, 4, Facing::Inward);
  TraceSettings settings;
  settings.registerBackSide = true;
  const TracedMap run(
    room, DiskLamp{ { 1.3, 1.9, High.z + 1e-3 }, { 0, 0, -1 }, 0.1, Lumens }, settings, Photons);
  EXPECT_EQ(run.RegisteredFlux(run.front), 0.0);
  Report("lamps that are moved through a ceiling they do not touch",
    "1 mm behind the ceiling: no light in the room");
}

namespace
{

/// Screens above and below a double sheet or a pane of glass at z = 0.
Surface Between(bool glass)
{
  const Surface up = Shapes::Rectangle({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 3);
  const Surface down = Shapes::Rectangle({ -2, -2, 0 }, { 0, 4, 0 }, { 4, 0, 0 }, 5);
  Surface all = glass ? up : Shapes::Together(up, down);
  const std::size_t middle = all.facets.size();
  all = Shapes::Together(all, Shapes::Rectangle({ -9, -9, 0.5 }, { 0, 18, 0 }, { 18, 0, 0 }, 4));
  all = Shapes::Together(all, Shapes::Rectangle({ -9, -9, -0.5 }, { 18, 0, 0 }, { 0, 18, 0 }, 4));
  if (glass)
  {
    all.materials.assign(2, {});
    all.materials[0].clearTransmittance = Colour(1.0f);
    all.materialOfFacet.assign(all.facets.size(), 1);
    std::fill_n(all.materialOfFacet.begin(), middle, 0u);
  }
  return all;
}

} // namespace

// On a wall that is drawn once for each side, and on a pane of glass, it lights its own side.
TEST_F(LampPlace, OnDoubleSheetsAndGlass)
{
  const auto expectOnSide =
    [&](const Surface& still, const Surface& surface, double side, const Lamp& lamp)
  {
    const TracedMap run(surface, lamp, TraceSettings(), Photons);
    double right = 0.0, wrong = 0.0;
    for (std::size_t v = 0; v < surface.points.size(); ++v)
    {
      const double lux = run.front.direct[v] + run.front.indirect[v];
      (side * still.points[v].z > 0.1 ? right : wrong) += lux;
    }
    EXPECT_GT(right, 0.0);
    EXPECT_EQ(wrong, 0.0);
    ++this->Lamps;
  };
  for (const double degrees : Turns)
  {
    const Motion motion = Turned(degrees);
    for (const bool glass : { false, true })
    {
      const Surface still = Between(glass);
      const Surface surface = Moved(still, motion);
      for (const double side : { 1.0, -1.0 })
      {
        SCOPED_TRACE((glass ? "glass" : "sheets") + (", side " + std::to_string(side)));
        this->ForEachLamp(motion, { 0.2, 0.3, 0.0 }, { 0, 0, side },
          [&](const Lamp& lamp)
          {
            if (!std::holds_alternative<PointLamp>(lamp)) // it has no side of its own
            {
              expectOnSide(still, surface, side, lamp);
            }
          });
      }
    }
  }
  Report("lamps on walls drawn once for each side, and on glass",
    std::to_string(this->Lamps) + " lamps: no light on the other side");
}
