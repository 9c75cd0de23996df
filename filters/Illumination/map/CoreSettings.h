// SPDX-License-Identifier: BSD-3-Clause
// The filters' properties in the core's terms.
#ifndef CoreSettings_h
#define CoreSettings_h

#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/transport/IlluminationRun.h"

class vtkIlluminationMap;
class vtkIlluminationMapSmoothing;
struct LuminaireInput;

/// Throws InputError for data that describe no luminaire, or a wrong one.
/// @param luminaires What is connected; the filter's own lamp serves if nothing is.
PhotonTransport::Lighting LightingOf(
  vtkIlluminationMap* filter, const std::vector<LuminaireInput>& luminaires);
PhotonTransport::TraceSettings SettingsOf(vtkIlluminationMap* filter);
PhotonTransport::StopRules RulesOf(vtkIlluminationMap* filter);

/// Bytes, 0 for what the machine has. Throws InputError for a limit that is none.
std::uint64_t MemoryLimitOf(vtkIlluminationMap* filter);

/// Throws InputError for values out of range, and if the lamp needs an array and none is named.
/// @param otherLamps Whether luminaires are connected, so that the filter's own lamp is off.
SurfaceDescription DescriptionOf(vtkIlluminationMap* filter, bool otherLamps);

/// Throws InputError for an angle out of range.
PhotonTransport::FiltrationSettings SettingsOf(vtkIlluminationMapSmoothing* filter);

/// ParaView's lists of arrays send the word "None" for no array.
std::string ArrayName(const char* name);

#endif
