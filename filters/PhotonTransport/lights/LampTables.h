// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <glm/vec3.hpp>

#include <memory>

namespace PhotonTransport
{

/// The intensities of a solid, cd. Throws InvalidInput for a solid whose angles or intensities
/// break the promises of PhotometricSolid, or that is dark.
std::shared_ptr<const DirectionTable> TableOf(const PhotometricSolid& solid);

/// Luminance relative to the zenith's. The polar angle counts from the zenith, the azimuth from the
/// sun. The table holds the half of the sky on one side of the sun; the other half is its mirror
/// image. Its step is half a degree. Between its angles it differs from the formula, on average and
/// relative to the mean luminance, by less than 1e-4 for types 1 to 13 and by up to 2.1e-4 for
/// types 14 and 15 with a low sun.
DirectionTable SkyTable(int type, double sunZenithAngle);

/// The luminance of a sky's zenith, cd/m^2, that gives its horizontal illuminance. @param table The
/// SkyTable of the same sky. Throws InvalidInput for an illuminance that is not finite or below 0.
double ZenithLuminance(const CieSky& sky, const DirectionTable& table);

/// The angle between zenith and sun, radians. Throws InvalidInput unless the sun is above the
/// horizon.
double SunZenithAngle(const CieSky& sky);

/// The axes of a photometric lamp; see PhotometricLamp::direction.
struct LampAxes
{
  glm::dvec3 aim, x, y; ///< Orthonormal. x and y are +x and +y of the lamp before it is turned.
};

/// The unit vector along a panel's width. @param aim Its direction, unit. Throws InvalidInput for
/// a width that runs along the aim.
glm::dvec3 WidthAxis(const RectangleLamp& lamp, const glm::dvec3& aim);

/// @param aim Unit. @param rotation Radians.
LampAxes AxesOf(const glm::dvec3& aim, double rotation);

} // namespace PhotonTransport
