// SPDX-License-Identifier: BSD-3-Clause
#ifndef IlluminationArrays_h
#define IlluminationArrays_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <string>
#include <vector>

class SceneBlocks;
class vtkFieldData;
class vtkTable;

/// Adds the map's point arrays to each block's data.
void AddPointArrays(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run, bool backSide);

/// Adds the light by colour, where there is any, and by luminaire.
/// @param lighting Whose luminaires are kept apart; null if none are.
void AddLayers(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run, const PhotonTransport::Lighting* lighting);

/// Adds what the smoothing of the map works best with.
void AddGroupMeans(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run);

/// Adds what concerns the run as a whole: photon balance, time, effects, notes.
void AddFieldData(vtkFieldData* output, const PhotonTransport::IlluminationRun& run,
  PhotonTransport::StopReason reason, const std::vector<std::string>& notes);

/// Adds what the run was expected to take at most, in bytes.
void AddMemoryNeeded(vtkFieldData* output, std::uint64_t bytes);

/// A row for each round.
void FillAccuracyTable(vtkTable* table, const std::vector<PhotonTransport::Accuracy>& rounds);

/// What was found in the input and mended, in words; empty if nothing was.
std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

/// What the readers of photometric files assumed.
std::vector<std::string> NotesOn(const PhotonTransport::Lighting& lighting);

#endif
