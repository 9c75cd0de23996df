// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/LampTables.h"

#include "PhotonTransport/lights/CieSkyLuminance.h"
#include "PhotonTransport/lights/LampChecks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace PhotonTransport
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

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

} // namespace

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

double ZenithLuminance(const CieSky& sky, const DirectionTable& table)
{
  return CheckedAmount(sky.horizontalIlluminance, "horizontal illuminance") /
    (2.0 * table.CosineIntegral());
}

double SunZenithAngle(const CieSky& sky)
{
  const glm::dvec3 up = CheckedDirection(sky.up, "direction upwards");
  const glm::dvec3 sun = CheckedDirection(sky.sun, "direction to the sun");
  const double angle = std::acos(std::clamp(glm::dot(up, sun), -1.0, 1.0));
  if (!(angle < 0.5 * Pi))
  {
    RefuseLamp("the sun of a sky is " + Text(angle * 180.0 / Pi) +
      " degrees from the zenith; it must be above the horizon, less than 90");
  }
  return angle;
}

glm::dvec3 WidthAxis(const RectangleLamp& lamp, const glm::dvec3& aim)
{
  constexpr double Parallel = 1e-6; // sine between the two axes
  if (lamp.across != glm::dvec3(0.0))
  {
    const glm::dvec3 across = CheckedDirection(lamp.across, "lamp width's axis");
    const glm::dvec3 inPlane = across - glm::dot(across, aim) * aim;
    if (!(glm::length(inPlane) > Parallel))
    {
      RefuseLamp("lamp width's axis runs along the lamp's direction");
    }
    return glm::normalize(inPlane);
  }
  const glm::dvec3 level = glm::cross(glm::dvec3(0.0, 0.0, 1.0), aim);
  return glm::length(level) > Parallel ? glm::normalize(level) : glm::dvec3(1.0, 0.0, 0.0);
}

LampAxes AxesOf(const glm::dvec3& aim, double rotation)
{
  // The lamp turned about its aim while it still looks down, where x, y and -z are its axes ...
  const glm::dvec3 x(std::cos(rotation), std::sin(rotation), 0.0);
  const glm::dvec3 y(-std::sin(rotation), std::cos(rotation), 0.0);
  // ... and then tilted the shortest way: about the axis across both aims (Rodrigues).
  const glm::dvec3 down(0.0, 0.0, -1.0);
  const double cosine = glm::dot(down, aim);
  if (cosine < -1.0 + 1e-12)
  {
    return { aim, { x.x, -x.y, 0.0 }, { y.x, -y.y, 0.0 } }; // half a turn about x
  }
  const glm::dvec3 axis = glm::cross(down, aim);
  const auto turned = [&](const glm::dvec3& v)
  { return cosine * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine)); };
  return { aim, glm::normalize(turned(x)), glm::normalize(turned(y)) };
}

} // namespace PhotonTransport
