// SPDX-License-Identifier: BSD-3-Clause
#ifndef SensorScene_h
#define SensorScene_h

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/sensors/SensorRun.h"
#include "PhotonTransport/transport/MemoryBudget.h"
#include "PhotonTransport/transport/SkyOpenings.h"

namespace Illumination
{

/// The scene of a map and a run of sensors in it, in the order in which they need each other.
struct SensorScene
{
  /// Throws InvalidInput, as well if the memory is too short. @param settings Of the map.
  SensorScene(const PhotonTransport::Surface& surface, const PhotonTransport::Lighting& lighting,
    PhotonTransport::TraceSettings settings);

  PhotonTransport::Surface Traced; ///< The given surface, or curved patches along it.
  PhotonTransport::TraceSettings Settings;
  PhotonTransport::MemoryBudget Memory; ///< What the machine has.
  PhotonTransport::Scene Scene;
  PhotonTransport::FoundOpenings Openings;
  PhotonTransport::SensorRun Run;
};

} // namespace Illumination

#endif
