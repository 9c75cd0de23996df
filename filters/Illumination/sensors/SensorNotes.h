// SPDX-License-Identifier: BSD-3-Clause
#ifndef SensorNotes_h
#define SensorNotes_h

#include "Illumination/sensors/SensorInput.h"
#include "Illumination/sensors/SensorScene.h"

#include "PhotonTransport/sensors/SensorReader.h"

#include <string>
#include <vector>

namespace Illumination
{

/// What is to be said of sensors and what they have measured.
struct SensorNotes
{
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// @param whyNoDaylightFactor Of OutdoorIlluminance.
SensorNotes NotesOn(const SensorScene& scene, const SensorInput& input,
  const std::vector<PhotonTransport::SensorReading>& readings,
  const PhotonTransport::Lighting& lighting, const std::string& whyNoDaylightFactor);

} // namespace Illumination

#endif
