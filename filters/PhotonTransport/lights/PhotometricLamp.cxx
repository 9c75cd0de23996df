// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/PhotometricLamp.h"

#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <tuple>
#include <utility>

namespace PhotonTransport
{
namespace
{

std::vector<double> Radians(const std::vector<double>& degrees)
{
  std::vector<double> radians(degrees.size());
  std::transform(degrees.begin(), degrees.end(), radians.begin(),
    [](double angle) { return angle * (Pi / 180.0); });
  return radians;
}

bool Rises(const std::vector<double>& angles, double least, double most)
{
  // Negated comparisons find NaN too.
  bool rises = angles.size() >= 2 && angles.front() >= least && angles.back() <= most;
  for (std::size_t i = 1; i < angles.size() && rises; ++i)
  {
    rises = angles[i] > angles[i - 1];
  }
  return rises;
}

/// The intensities of a solid, cd. Throws InvalidInput for a solid whose angles or intensities
/// break the promises of PhotometricSolid, or that is dark.
std::shared_ptr<const DirectionTable> TableOf(const PhotometricSolid& solid)
{
  constexpr double Turn = 360.0 * (1.0 + 1e-12); // both ends of a full circle are rounded
  if (!Rises(solid.polar, 0.0, 180.0) || !Rises(solid.azimuth, -2.0 * Turn, 2.0 * Turn) ||
    solid.azimuth.back() - solid.azimuth.front() > Turn)
  {
    RefuseLamp("the angles of a photometric solid must rise, within 180 and 360 degrees");
  }
  const bool sound = solid.candela.size() == solid.polar.size() * solid.azimuth.size() &&
    std::all_of(solid.candela.begin(), solid.candela.end(),
      [](double intensity) { return intensity >= 0.0 && std::isfinite(intensity); });
  if (!sound)
  {
    RefuseLamp("a photometric solid must have one finite intensity >= 0 for each pair of angles");
  }
  auto table = std::make_shared<const DirectionTable>(
    Radians(solid.polar), Radians(solid.azimuth), solid.candela);
  if (!(table->Integral() > 0.0))
  {
    RefuseLamp("a photometric solid has no intensity above 0 cd");
  }
  return table;
}

/// Whether the intensities stay the same when the angles of the grid are replaced by others.
bool IsSame(
  const PhotometricSolid& solid, const std::function<void(double& polar, double& azimuth)>& replace)
{
  constexpr double Same = 1e-6; // of the largest intensity
  const double largest = *std::max_element(solid.candela.begin(), solid.candela.end());
  for (const double polar : solid.polar)
  {
    for (const double azimuth : solid.azimuth)
    {
      double otherPolar = polar;
      double otherAzimuth = azimuth;
      replace(otherPolar, otherAzimuth);
      const double difference =
        Intensity(solid, otherPolar, otherAzimuth) - Intensity(solid, polar, azimuth);
      if (std::fabs(difference) > Same * largest)
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether the mirror image of a lamp, left and right (x) or fore and aft (y), equals the lamp.
struct MirrorSymmetry
{
  bool x;
  bool y;
};

/// See PhotometricSolid for the angles of each type.
MirrorSymmetry SymmetryOf(const PhotometricSolid& solid)
{
  const bool back = IsSame(solid, [](double&, double& azimuth) { azimuth = -azimuth; });
  const bool across = IsSame(solid,
    [type = solid.type](double& polar, double& azimuth)
    {
      const bool isC = type == PhotometricSolid::Type::C;
      (isC ? azimuth : polar) = 180.0 - (isC ? azimuth : polar);
    });
  return solid.type == PhotometricSolid::Type::A ? MirrorSymmetry{ back, across }
                                                 : MirrorSymmetry{ across, back };
}

/// @param aim Unit.
PhotometricLamp::LampAxes AxesOf(const glm::dvec3& aim, double rotation)
{
  const ShortestTurn turn(aim);
  const double cosine = std::cos(rotation);
  const double sine = std::sin(rotation);
  return { aim, turn({ cosine, sine, 0.0 }), turn({ -sine, cosine, 0.0 }) };
}

} // namespace

std::string SolidTypeName(PhotometricSolid::Type type)
{
  const char* names[] = { "C", "B", "A" }; // as PhotometricSolid::Type counts
  return names[static_cast<int>(type)];
}

void CheckFields(const PhotometricSolid& solid,
  const std::function<void(const char* name, const std::string& message)>& refuse)
{
  const std::pair<const char*, const std::vector<double>&> grid[] = {
    { "PhotometricPolar", solid.polar }, { "PhotometricAzimuth", solid.azimuth }
  };
  for (const auto& [name, angles] : grid)
  {
    if (angles.size() < 2 ||
      std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) != angles.end())
    {
      refuse(name, "does not hold two or more rising angles");
    }
  }
  if (solid.polar.front() < 0.0 || solid.polar.back() > 180.0)
  {
    refuse("PhotometricPolar", "leaves [0, 180] degrees");
  }
  if (solid.azimuth.back() - solid.azimuth.front() > 360.0)
  {
    refuse("PhotometricAzimuth", "covers more than 360 degrees");
  }
  const std::size_t directions = solid.azimuth.size() * solid.polar.size();
  if (solid.candela.size() != directions)
  {
    refuse("PhotometricCandela",
      "has " + std::to_string(solid.candela.size()) + " values; " + std::to_string(directions) +
        " are wanted, one for each azimuth and polar angle");
  }
  if (*std::min_element(solid.candela.begin(), solid.candela.end()) < 0.0)
  {
    refuse("PhotometricCandela", "has values below 0");
  }
}

PhotometricLamp::LampAxes PhotometricLamp::Axes() const
{
  return AxesOf(CheckedDirection(this->direction), this->rotation);
}

void PhotometricLamp::Move(const Similarity& motion)
{
  const MirrorSymmetry same =
    motion.mirrors ? SymmetryOf(this->solid) : MirrorSymmetry{ true, true };
  if (!same.x && !same.y)
  {
    RefuseLamp("it was mirrored, and its intensities are not the same left and right; turn it in "
               "place of mirroring it");
  }
  const LampAxes axes = this->Axes();
  this->position = motion.Point(this->position);
  this->direction = Unit(motion.Direction(axes.aim));
  // One of the two sides, x or y, follows the motion; only the other one may be mirrored.
  const LampAxes unturned = AxesOf(this->direction, 0.0);
  const glm::dvec3 side = motion.Direction(same.y ? axes.x : axes.y);
  const double x = glm::dot(side, unturned.x);
  const double y = glm::dot(side, unturned.y);
  this->rotation = same.y ? std::atan2(y, x) : std::atan2(-x, y);
}

LampNotes PhotometricLamp::Notes(const std::string& name) const
{
  LampNotes notes;
  std::transform(this->solid.notes.begin(), this->solid.notes.end(), std::back_inserter(notes),
    [&](const std::string& note)
    { return "photometric file of luminaire '" + name + "', " + note; });
  return notes;
}

Prepared<TableEmitter> PhotometricLamp::Prepare(const Scene& scene) const
{
  if (!std::isfinite(this->rotation))
  {
    RefuseLamp("lamp rotation " + Text(this->rotation) + " is not finite");
  }
  const auto table = TableOf(this->solid);
  const LampAxes axes = this->Axes();
  const glm::dvec3 place = ClearPosition(this->position, scene, axes.aim);
  const double flux = CheckedAmount(this->scale, "dimming") * table->Integral();
  const double perSquareMetre = 1.0 / scene.SquareMetresPerSceneArea();
  TableEmitter lamp;
  lamp.position = place;
  lamp.table = table;
  lamp.aim = axes.aim;
  lamp.openArea = this->solid.width * this->solid.length * perSquareMetre;
  // The width of a rectangle as seen across the aim is w |cos| + l |sin|.
  lamp.sideArea =
    this->solid.height * (this->solid.width + this->solid.length) * 2.0 / Pi * perSquareMetre;
  // See PhotometricSolid.
  switch (this->solid.type)
  {
    case PhotometricSolid::Type::A:
      std::tie(lamp.azimuth0, lamp.azimuth90, lamp.pole) = std::tie(axes.aim, axes.x, axes.y);
      break;
    case PhotometricSolid::Type::B:
      std::tie(lamp.azimuth0, lamp.azimuth90, lamp.pole) = std::tie(axes.aim, axes.y, axes.x);
      break;
    default:
      std::tie(lamp.azimuth0, lamp.azimuth90, lamp.pole) = std::tie(axes.x, axes.y, axes.aim);
      break;
  }
  return { lamp, flux };
}

double TableEmitter::SeenArea(const glm::dvec3& direction) const
{
  const double cosine = std::fabs(glm::dot(direction, this->aim));
  const double area =
    cosine * this->openArea + std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * this->sideArea;
  constexpr double Least = 1e-3; // of a flat opening that is seen edge on
  return std::max(area, Least * this->openArea);
}

Ray TableEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  const glm::dvec2 angles = this->table->Sample(sample.Emission(0), sample.Emission(1));
  return RayFrom(
    this->position, UnitDirection(angles, this->azimuth0, this->azimuth90, this->pole));
}

Incidence TableEmitter::Arriving(const glm::dvec3& point, float, float) const
{
  const glm::dvec3 way = point - this->position;
  const double d2 = glm::dot(way, way);
  if (!(d2 > 0.0))
  {
    return {};
  }
  const double intensity =
    this->table->Value(AnglesOf(way, this->azimuth0, this->azimuth90, this->pole)) /
    this->table->Integral();
  return { point, this->position, intensity / d2 };
}

} // namespace PhotonTransport
