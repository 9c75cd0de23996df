// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <glm/vec3.hpp>

#include <memory>

namespace PhotonTransport
{

/// cd. Throws InvalidInput for a solid that contradicts itself or is dark.
std::shared_ptr<const DirectionTable> TableOf(const PhotometricSolid& solid);

/// Luminance relative to the zenith's; polar angle from the zenith, azimuth from the sun's, of the
/// half on one side of the sun: the other half is its mirror image. Fine enough that what lies
/// between its angles is off by less than 1e-4 on average.
DirectionTable SkyTable(int type, double sunZenithAngle);

/// cd/m^2 of a sky's zenith, by its horizontal illuminance. @param table Of the same sky.
double ZenithLuminance(const CieSky& sky, const DirectionTable& table);

/// Radians between zenith and sun. Throws InvalidInput unless the sun is above the horizon.
double SunZenithAngle(const CieSky& sky);

/// Where a lamp with an aim has its sides; see PhotometricLamp::direction.
struct LampAxes
{
  glm::dvec3 aim, x, y; ///< Orthonormal; x and y as seen by an unturned lamp.
};

/// The unit vector along a panel's width. @param aim Its direction, unit. Throws InvalidInput for
/// a width across the panel's plane.
glm::dvec3 WidthAxis(const RectangleLamp& lamp, const glm::dvec3& aim);

/// @param aim Unit. @param rotation Radians.
LampAxes AxesOf(const glm::dvec3& aim, double rotation);

} // namespace PhotonTransport
