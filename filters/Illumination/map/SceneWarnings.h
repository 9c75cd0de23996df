// SPDX-License-Identifier: BSD-3-Clause
// What the user should know of facets that are too close together or too small for the scene.
#ifndef SceneWarnings_h
#define SceneWarnings_h

#include <string>
#include <vector>

namespace PhotonTransport
{
class Scene;
}

namespace Illumination
{

class SceneBlocks;

/// How facets that face the same way in one place were treated. Empty if there are none.
std::vector<std::string> NotesOnSharedPlaces(
  const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

/// What makes the map wrong in some places, and what to do about each: facets in one place that
/// have other materials or both shine, and gaps or facets too small for the scene's coordinates.
std::vector<std::string> WarningsOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene);

} // namespace Illumination

#endif
