// SPDX-License-Identifier: BSD-3-Clause
// What the user should know of facets that the scene can't tell apart.
#ifndef SceneWarnings_h
#define SceneWarnings_h

#include <string>
#include <vector>

class SceneBlocks;

namespace PhotonTransport
{
class Scene;
}

/// Facets in one place that face the same way: what was made of them. Empty if there are none.
std::vector<std::string> NotesOnSharedPlaces(
  const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

/// What makes the map wrong in some places, each with what to do: facets in one place of which only
/// one can be right, and gaps or facets too small for the scene's coordinates.
std::vector<std::string> WarningsOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

#endif
