// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

/// Luminance of a point of the sky over that of the zenith, by ISO 15469:2004 / CIE S 011:2003.
/// @param type 1 to 15: the standard's general skies; 16: its traditional overcast sky.
/// @param zenithAngle Of the point, radians, [0, pi/2]. @param sunZenithAngle Of the sun.
/// @param angleToSun Between the two.
double RelativeSkyLuminance(int type, double zenithAngle, double sunZenithAngle, double angleToSun);

} // namespace PhotonTransport
