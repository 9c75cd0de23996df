// SPDX-License-Identifier: BSD-3-Clause
// The filters' properties in the core's terms.
#ifndef CoreSettings_h
#define CoreSettings_h

#include "SceneBlocks.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/transport/IlluminationRun.h"

class vtkIlluminationMap;
class vtkIlluminationMapSmoothing;
struct LuminaireInput;

/// The connected luminaires, or the filter's own lamp if there are none. Throws InputError for data
/// that describe no luminaire or an invalid one.
/// @param luminaires What is connected.
PhotonTransport::Lighting LightingOf(
  vtkIlluminationMap* filter, const std::vector<LuminaireInput>& luminaires);
/// Throws InputError for a maximum path length below 0; the core's Validate checks the rest.
PhotonTransport::TraceSettings SettingsOf(vtkIlluminationMap* filter);
/// Throws InputError for a number of photons that is not whole or below 0; the core's Validate
/// checks the rest.
PhotonTransport::StopRules RulesOf(vtkIlluminationMap* filter);

/// Bytes, 0 for what the machine has. Throws InputError for a limit below 0 or not finite.
std::uint64_t MemoryLimitOf(vtkIlluminationMap* filter);

/// Throws InputError for values out of range, and if the lamp is EMITTING_FACETS and no
/// ExitanceArray is named.
/// @param otherLamps Whether luminaires are connected, so that the filter's own lamp is off.
SurfaceDescription DescriptionOf(vtkIlluminationMap* filter, bool otherLamps);

/// Throws InputError for an angle out of range; the core's Validate checks the rest.
PhotonTransport::FiltrationSettings SettingsOf(vtkIlluminationMapSmoothing* filter);

/// The name of an array; empty for "None", which ParaView's lists of arrays send for no array.
std::string ArrayName(const char* name);

#endif
