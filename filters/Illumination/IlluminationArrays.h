// SPDX-License-Identifier: BSD-3-Clause
#ifndef IlluminationArrays_h
#define IlluminationArrays_h

#include <string>
#include <vector>

class SceneBlocks;
class vtkDataObject;
class vtkFieldData;
class vtkPolyData;
struct SceneBlock;

namespace PhotonTransport
{
struct IlluminationMap;
class Scene;
}

/// Adds the map's point arrays to a block's output. @param output Same points as `block.data`.
void AddPointArrays(vtkPolyData* output, const SceneBlock& block,
  const PhotonTransport::Scene& scene, const PhotonTransport::IlluminationMap& map);

/// Adds what concerns the run as a whole: photon balance, time, effects, notes.
void AddFieldData(vtkFieldData* output, const PhotonTransport::IlluminationMap& map,
  const std::vector<std::string>& notes);

/// What was found in the input and mended, in words; empty if nothing was.
std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

#endif
