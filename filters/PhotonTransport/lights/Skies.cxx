// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Skies.h"

#include "PhotonTransport/lights/CieSkyLuminance.h"
#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Of the ball about the scene's origin that holds all facets.
double BallRadius(const Scene& scene)
{
  double radius = 0.0;
  for (const Vertex& vertex : scene.Vertices())
  {
    if (vertex.inverseThreeAreas > 0.0f)
    {
      radius = std::max(radius, glm::length(glm::dvec3(vertex.position)));
    }
  }
  return radius + FloatSlack;
}

/// m^2 that the ball shows to each direction.
double CrossSection(double radius, const Scene& scene)
{
  return Pi * radius * radius * scene.SquareMetresPerSceneArea();
}

/// From far outside, in a direction opposite to `from`, onto the ball that holds the scene.
Ray OntoBall(const glm::vec3& from, float radius, const PhotonSample& sample)
{
  const Frame frame(from);
  const glm::vec2 p = radius * sample.OnDisk(0);
  return { p.x * frame.tangent + p.y * frame.bitangent + radius * frame.normal, -frame.normal };
}

/// Radians between unit vectors.
double AngleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

/// The angle between zenith and sun, radians. Throws InvalidInput unless the sun is above the
/// horizon.
double SunZenithAngle(const CieSky& sky)
{
  const double angle = AngleBetween(CheckedDirection(sky.up, "direction upwards"),
    CheckedDirection(sky.sun, "direction to the sun"));
  if (!(angle < 0.5 * Pi))
  {
    RefuseLamp("the sun of a sky is " + Text(angle * 180.0 / Pi) +
      " degrees from the zenith; it must be above the horizon, less than 90");
  }
  return angle;
}

/// Luminance relative to the zenith's. The polar angle counts from the zenith, the azimuth from the
/// sun. The table holds the half of the sky on one side of the sun; the other half is its mirror
/// image. Its step is half a degree. Between its angles it differs from the formula, on average and
/// relative to the mean luminance, by less than 1e-4 for types 1 to 13 and by up to 2.1e-4 for
/// types 14 and 15 with a low sun.
DirectionTable SkyTable(int type, double sunZenithAngle)
{
  constexpr int Polar = 180;   // half a degree each
  constexpr int Azimuth = 360; // the same, of half a turn
  std::vector<double> polar, azimuth, luminance;
  for (int p = 0; p <= Polar; ++p)
  {
    polar.push_back(0.5 * Pi * p / Polar);
  }
  for (int z = 0; z <= Azimuth; ++z)
  {
    azimuth.push_back(Pi * z / Azimuth);
    for (const double angle : polar)
    {
      // Spherical trigonometry: the angle between a point of the sky and the sun.
      const double cosine = std::cos(angle) * std::cos(sunZenithAngle) +
        std::sin(angle) * std::sin(sunZenithAngle) * std::cos(azimuth.back());
      luminance.push_back(RelativeSkyLuminance(
        type, angle, sunZenithAngle, std::acos(std::clamp(cosine, -1.0, 1.0))));
    }
  }
  return { std::move(polar), std::move(azimuth), std::move(luminance) };
}

/// The luminance of a sky's zenith, cd/m^2, that gives its horizontal illuminance.
double ZenithLuminance(const CieSky& sky, const DirectionTable& table)
{
  return CheckedAmount(sky.horizontalIlluminance, "horizontal illuminance") /
    (2.0 * table.CosineIntegral());
}

} // namespace

Prepared<SkyEmitter> UniformSky::Prepare(const Scene& scene) const
{
  const double radius = BallRadius(scene);
  const double solidAngle = this->wholeSphere ? 4.0 * Pi : 2.0 * Pi;
  return { { {}, FrameOf(CheckedDirection(this->up)), this->wholeSphere,
             static_cast<float>(radius) },
    CheckedAmount(this->luminance, "luminance") * CrossSection(radius, scene) * solidAngle };
}

void CieSky::Move(const Similarity& motion)
{
  this->up = motion.Direction(this->up);
  this->sun = motion.Direction(this->sun);
}

Prepared<TableSkyEmitter> CieSky::Prepare(const Scene& scene) const
{
  if (this->type < 1 || this->type > 16)
  {
    RefuseLamp("sky type " + std::to_string(this->type) + " is outside 1 to 16");
  }
  const double sunZenithAngle = SunZenithAngle(*this);
  const glm::dvec3 zenith = CheckedDirection(this->up);
  const glm::dvec3 toSun = CheckedDirection(this->sun);
  const glm::dvec3 level = toSun - glm::dot(toSun, zenith) * zenith;
  const glm::dvec3 azimuth0 =
    glm::length(level) > FloatSlack ? glm::normalize(level) : glm::dvec3(FrameOf(zenith).tangent);
  const auto table = std::make_shared<const DirectionTable>(SkyTable(this->type, sunZenithAngle));
  const double radius = BallRadius(scene);
  return { { {}, azimuth0, glm::cross(zenith, azimuth0), zenith, static_cast<float>(radius),
             table },
    ZenithLuminance(*this, *table) * 2.0 * table->Integral() * CrossSection(radius, scene) };
}

std::vector<double> CieSky::Luminance(const std::vector<glm::dvec3>& towards) const
{
  const double sunZenithAngle = SunZenithAngle(*this);
  const double zenith = ZenithLuminance(*this, SkyTable(this->type, sunZenithAngle));
  std::vector<double> luminance;
  for (const glm::dvec3& place : towards)
  {
    const glm::dvec3 direction = Unit(place);
    luminance.push_back(zenith *
      RelativeSkyLuminance(this->type, std::min(AngleBetween(direction, Unit(this->up)), 0.5 * Pi),
        sunZenithAngle, AngleBetween(direction, Unit(this->sun))));
  }
  return luminance;
}

Ray SkyEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  glm::vec3 from = UniformSphereAbove(sample.OnDisk(1));
  if (!this->wholeSphere)
  {
    from.z = std::fabs(from.z);
  }
  return OntoBall(this->up.ToWorld(from), this->radius, sample);
}

double SkyEmitter::RadiancePerLumen(const glm::vec3& towards) const
{
  if (!this->wholeSphere && glm::dot(towards, this->up.normal) < 0.0f)
  {
    return 0.0;
  }
  const double solidAngle = this->wholeSphere ? 4.0 * Pi : 2.0 * Pi;
  return 1.0 / (Pi * double{ this->radius } * this->radius * solidAngle);
}

double TableSkyEmitter::RadiancePerLumen(const glm::vec3& towards) const
{
  // The table has one half of the sky, and the other half is its mirror image.
  glm::dvec2 angles = AnglesOf(glm::dvec3(towards), this->azimuth0, this->azimuth90, this->up);
  angles.y = std::fabs(angles.y);
  return this->table->Value(angles) /
    (2.0 * this->table->Integral() * Pi * double{ this->radius } * this->radius);
}

Ray TableSkyEmitter::Emit(const PhotonSample& sample, const Share&) const
{
  // One number chooses the side of the sun and the azimuth on that side. Numbers that are close
  // give places that are close in the sky, also across the sun's meridian.
  const double turn = 2.0 * sample.Emission(3) - 1.0;
  const glm::dvec2 angles =
    this->table->Sample(sample.Emission(2), std::min(std::fabs(turn), 1.0 - 0x1p-53));
  const glm::dvec3 beside = turn < 0.0 ? -this->azimuth90 : this->azimuth90;
  return OntoBall(UnitDirection(angles, this->azimuth0, beside, this->up), this->radius, sample);
}

} // namespace PhotonTransport
