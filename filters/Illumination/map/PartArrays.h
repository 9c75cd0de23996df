// SPDX-License-Identifier: BSD-3-Clause
// Colours and lamps apart, as point arrays.
#ifndef PartArrays_h
#define PartArrays_h

#include "Illumination/map/PointMapping.h"

#include <vector>

namespace PhotonTransport
{
class IlluminationRun;
struct IlluminationMap;
struct Lighting;
struct RefinedMap;
}

namespace Illumination
{

/// Adds IlluminanceRGB where there is colour, and Illuminance_NAME of each lamp, with standard
/// errors where photons alone have brought the light. @param front The light of all parts.
/// @param lighting Null if no lamps are kept apart.
void AddParts(const std::vector<PointMapping>& mappings,
  const PhotonTransport::IlluminationRun& run, const PhotonTransport::IlluminationMap& front,
  const PhotonTransport::Lighting* lighting);

/// The same on a refined surface, without errors.
void AddParts(const std::vector<PointMapping>& mappings, const PhotonTransport::RefinedMap& map,
  const PhotonTransport::Lighting* lighting);

} // namespace Illumination

#endif
