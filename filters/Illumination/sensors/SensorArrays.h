// SPDX-License-Identifier: BSD-3-Clause
// What sensors have measured as arrays.
#ifndef SensorArrays_h
#define SensorArrays_h

#include "Illumination/sensors/SensorInput.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/sensors/SensorReader.h"

#include <optional>
#include <string>
#include <vector>

namespace Illumination
{

/// The illuminance of open level ground, lx, if all luminaires are overcast (CIE types 1 and 16) or
/// uniform skies above the same horizon: what daylight factors are relative to.
/// @param up Unit. @param why Gets the reason if there are skies and it is nothing.
std::optional<double> OutdoorIlluminance(
  const PhotonTransport::Lighting& lighting, const glm::dvec3& up, std::string& why);

/// Whether no luminaire has an area and a luminance, which a glare rating needs.
bool NoneHasLuminance(const PhotonTransport::Lighting& lighting);

/// Adds point arrays to all blocks. @param outdoors For daylight factors, lx; nothing: none.
/// @param azimuth Of the first view, degrees, which components are named after.
void AddSensorArrays(const std::vector<SensorBlock>& blocks,
  const std::vector<PhotonTransport::SensorReading>& readings, std::optional<double> outdoors,
  double azimuth);

} // namespace Illumination

#endif
