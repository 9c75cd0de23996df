// SPDX-License-Identifier: BSD-3-Clause
#ifndef IlluminationArrays_h
#define IlluminationArrays_h

#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/RefinedMap.h"

#include <string>
#include <vector>

namespace Illumination
{

class SceneBlocks;

/// Point arrays beyond those that every map has.
struct WantedArrays
{
  bool backSide; ///< IlluminanceBack and StandardErrorBack.
  /// IlluminanceDirectGroups and IlluminanceIndirectGroups, by which the map is best smoothed.
  /// There are none with a second pass, or if the run ended before each group had a photon.
  bool groupMeans;
  /// Illuminance_<name> for each of these luminaires; null if they are not kept apart.
  const PhotonTransport::Lighting* ofLamps;
};

/// Adds Illuminance, IlluminanceDirect, IlluminanceIndirect, StandardError, RelativeError and
/// PhotonHits and FacetError or, if there is a second pass, IlluminanceCaustic to each block's
/// point data, IlluminanceRGB if the run has colours, and what is wanted.
void AddPointArrays(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run, const WantedArrays& wanted);

/// The same of a map on a refined surface, which takes the place of each block's own; see
/// RefinedBlocks.
void AddRefinedBlocks(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::RefinedMap& map, const WantedArrays& wanted);

/// What was found in the input, and mended or left out, in words; empty if there was nothing.
std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

/// What the readers of photometric files assumed, in words.
std::vector<std::string> NotesOn(const PhotonTransport::Lighting& lighting);

} // namespace Illumination

#endif
