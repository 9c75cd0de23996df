// SPDX-License-Identifier: BSD-3-Clause
#ifndef RefinedScene_h
#define RefinedScene_h

#include "Illumination/surface/SceneBlock.h"

#include "PhotonTransport/refinement/RefinedMesh.h"

#include <vector>

namespace Illumination
{

class SceneBlocks;

/// Puts the refined surface in the place of each block's own, with its arrays (see RefinedBlocks).
/// @param mesh The refined surface of all blocks.
/// @return The blocks. Their points get the values of the mesh's points, as borrowed vertices do.
std::vector<SceneBlock> RefineBlocks(
  const SceneBlocks& blocks, const PhotonTransport::RefinedMesh& mesh);

} // namespace Illumination

#endif
