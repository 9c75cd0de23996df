// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshNotes_h
#define MeshNotes_h

#include <string>
#include <vector>

namespace PhotonTransport
{
struct SceneNotes;
}

namespace Illumination
{

class SceneBlocks;

/// What was found in the cells, points and normals, and mended or left out, in words; empty if
/// there was nothing.
std::vector<std::string> NotesOnMesh(
  const SceneBlocks& blocks, const PhotonTransport::SceneNotes& found);

} // namespace Illumination

#endif
