// SPDX-License-Identifier: BSD-3-Clause
// The filter's properties in the core's terms.
#ifndef CoreSettings_h
#define CoreSettings_h

#include "SceneBlocks.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/transport/IlluminationRun.h"

class vtkIlluminationMap;

PhotonTransport::Lamp LampOf(vtkIlluminationMap* filter);
PhotonTransport::TraceSettings SettingsOf(vtkIlluminationMap* filter);
PhotonTransport::StopRules RulesOf(vtkIlluminationMap* filter);

/// Bytes, 0 for what the machine has. Throws InputError for a limit that is none.
std::uint64_t MemoryLimitOf(vtkIlluminationMap* filter);

/// Throws InputError if the lamp needs an array and none is named.
SurfaceDescription DescriptionOf(vtkIlluminationMap* filter);

#endif
