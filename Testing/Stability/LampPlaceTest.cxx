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

/// All photons must arrive at fronts, and none escape.
void ExpectAllOnFronts(const Surface& surface, const Lamp& lamp)
{
  TraceSettings settings;
  settings.registerBackSide = true;
  settings.registration = Registration::Flat;
  const SoundRun run(surface, lamp, settings, Photons);
  EXPECT_EQ(run.balance.escaped, 0u);
  EXPECT_NEAR(run.RegisteredFlux(run.front), run.flux, 1e-6 * run.flux);
  EXPECT_EQ(run.RegisteredFlux(run.back), 0.0);
}

const double Turns[] = { 0.0, 10.0, 30.0, 37.0, 45.0, 123.0 }; // degrees

} // namespace

TEST(LampPlace, RecessedLampsLightTheRoom)
{
  int lamps = 0;
  for (const double degrees : Turns)
  {
    for (const double shift : { 0.0, 1e3 / 3.0, 1e6 / 3.0 })
    {
      const Motion motion{ glm::radians(degrees), glm::dvec3(shift) };
      const Surface room = Moved(Shapes::Box(Low, High, 4, Facing::Inward), motion);
      for (const Lamp& lamp :
        LampsAt(motion.Point({ 1.3, 1.9, High.z }), motion.Direction({ 0, 0, -1 })))
      {
        SCOPED_TRACE(std::to_string(degrees) + " degrees, moved by " + std::to_string(shift) +
          ", lamp " + std::to_string(lamp.index()));
        ExpectAllOnFronts(room, lamp);
        ++lamps;
      }
    }
  }
  Report("recessed lamps, whose light rounding puts on the ceiling's back",
    std::to_string(lamps) + " lamps of all kinds in turned rooms: all light on fronts");
}

TEST(LampPlace, OnEveryWallEdgeCornerAndVertex)
{
  for (const double degrees : { 0.0, 37.0 })
  {
    const Motion motion{ glm::radians(degrees), glm::dvec3(0.0) };
    const Surface room = Moved(Shapes::Box(Low, High, 4, Facing::Inward), motion);
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
      ExpectAllOnFronts(room, PointLamp{ where, Lumens });
      const glm::dvec3 aim = glm::normalize(motion.Direction(inwards));
      ExpectAllOnFronts(room, LambertianPointLamp{ where, aim, Lumens });
      ExpectAllOnFronts(room, SpotLamp{ where, aim, 0.6, 0.0, Lumens });
      ExpectAllOnFronts(room, SphereLamp{ where, 0.0, Lumens });
    }
  }
}

// A tube in the edge of ceiling and wall, and one across the ceiling: in front of both.
TEST(LampPlace, TubesOnWallsAndEdges)
{
  for (const double degrees : Turns)
  {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    const Motion motion{ glm::radians(degrees), glm::dvec3(0.0) };
    const Surface room = Moved(Shapes::Box(Low, High, 4, Facing::Inward), motion);
    for (const glm::dvec3& centre :
      { glm::dvec3(2.0, 2.5, High.z), glm::dvec3(2.0, 0.0, High.z), glm::dvec3(2.0, 0.0, 0.0) })
    {
      ExpectAllOnFronts(
        room, LineLamp{ motion.Point(centre), motion.Direction({ 1, 0, 0 }), 1.2, Lumens });
    }
  }
}

// Within rounding a lamp is in the ceiling, on either side of it; in front of it, it is where it
// is.
TEST(LampPlace, JustBesideTheCeiling)
{
  for (const double degrees : Turns)
  {
    const Motion motion{ glm::radians(degrees), glm::dvec3(0.0) };
    const Surface room = Moved(Shapes::Box(Low, High, 4, Facing::Inward), motion);
    for (const double behind : { 1e-9, 1e-8, 1e-7, 1e-6, -1e-9, -1e-8, -1e-7, -1e-6, -1e-5, -1e-4,
           -1e-3 }) // of the room's size
    {
      const glm::dvec3 place = motion.Point({ 1.3, 1.9, High.z + behind * High.y });
      for (const Lamp& lamp : LampsAt(place, motion.Direction({ 0, 0, -1 })))
      {
        SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(behind * 1e9) +
          "e-9 behind, lamp " + std::to_string(lamp.index()));
        ExpectAllOnFronts(room, lamp);
      }
    }
  }
}

// Far behind the ceiling a lamp shines on its back, as it would.
TEST(LampPlace, BehindTheCeilingItStaysDark)
{
  const Surface room = Shapes::Box(Low, High, 4, Facing::Inward);
  TraceSettings settings;
  settings.registerBackSide = true;
  const SoundRun run(
    room, DiskLamp{ { 1.3, 1.9, High.z + 1e-3 }, { 0, 0, -1 }, 0.1, Lumens }, settings, Photons);
  EXPECT_EQ(run.RegisteredFlux(run.front), 0.0);
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
    all.materials.resize(2);
    all.materials[0].clearTransmittance = Colour(1.0f);
    all.materialOfFacet.assign(all.facets.size(), 1);
    std::fill_n(all.materialOfFacet.begin(), middle, 0u);
  }
  return all;
}

} // namespace

// On a wall that is drawn once for each side, and on a pane of glass, it lights its own side.
TEST(LampPlace, OnDoubleSheetsAndGlass)
{
  for (const double degrees : Turns)
  {
    const Motion motion{ glm::radians(degrees), glm::dvec3(0.0) };
    for (const bool glass : { false, true })
    {
      const Surface still = Between(glass);
      const Surface surface = Moved(still, motion);
      for (const double side : { 1.0, -1.0 })
      {
        for (const Lamp& lamp :
          LampsAt(motion.Point({ 0.2, 0.3, 0.0 }), motion.Direction({ 0, 0, side })))
        {
          if (std::holds_alternative<PointLamp>(lamp))
          {
            continue; // it has no side of its own
          }
          SCOPED_TRACE(std::to_string(degrees) + " degrees, side " + std::to_string(side) +
            ", lamp " + std::to_string(lamp.index()) + (glass ? ", glass" : ", sheets"));
          const SoundRun run(surface, lamp, TraceSettings(), Photons);
          double right = 0.0, wrong = 0.0;
          for (std::size_t v = 0; v < surface.points.size(); ++v)
          {
            const double lux = run.front.direct[v] + run.front.indirect[v];
            right += side * still.points[v].z > 0.1 ? lux : 0.0;
            wrong += side * still.points[v].z > 0.1 ? 0.0 : lux;
          }
          EXPECT_GT(right, 0.0);
          EXPECT_EQ(wrong, 0.0);
        }
      }
    }
  }
}
