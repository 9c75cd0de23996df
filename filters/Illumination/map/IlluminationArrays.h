// SPDX-License-Identifier: BSD-3-Clause
#ifndef IlluminationArrays_h
#define IlluminationArrays_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace Illumination
{

class SceneBlocks;

/// Point arrays beyond those that every map has.
struct WantedArrays
{
  bool backSide; ///< IlluminanceBack and StandardErrorBack.
  /// IlluminanceDirectGroups and IlluminanceIndirectGroups, by which the map is best smoothed.
  /// There are none if the run ended before each group had a photon.
  bool groupMeans;
  /// Illuminance_<name> for each of these luminaires; null if they are not kept apart.
  const PhotonTransport::Lighting* ofLamps;
};

/// Adds Illuminance, IlluminanceDirect, IlluminanceIndirect, StandardError, RelativeError and
/// PhotonHits to each block's point data, IlluminanceRGB if the run has colours, and what is
/// wanted.
void AddPointArrays(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run, const WantedArrays& wanted);

/// Adds what concerns the run as a whole: photon balance, time, effects, notes.
void AddFieldData(vtkFieldData* output, const PhotonTransport::IlluminationRun& run,
  PhotonTransport::StopReason reason, const std::vector<std::string>& notes);

/// Adds MemoryNeeded, the bytes that the run was expected to take at most.
void AddMemoryNeeded(vtkFieldData* output, std::uint64_t bytes);

/// Fills the table with a row for each round; without any it has columns and no row.
void FillAccuracyTable(vtkTable* table, const std::vector<PhotonTransport::Accuracy>& rounds);

/// What was found in the input, and mended or left out, in words; empty if there was nothing.
std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

/// What the readers of photometric files assumed, in words.
std::vector<std::string> NotesOn(const PhotonTransport::Lighting& lighting);

} // namespace Illumination

#endif
