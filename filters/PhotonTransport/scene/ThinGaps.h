// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

class Scene;

/// Gaps too thin for the rays there: a ray starts a little above the facet that it leaves
/// (OriginOffset), and where another facet is nearer than that, light passes it unseen. A gap
/// counts only where light may be in it: in front of both facets, or beside one that lets light
/// through.
struct ThinGaps
{
  std::size_t number = 0; ///< Facets that have such a gap at their middle.
  /// The two of the thinnest gap; the first in the list of several. FindThinGaps gives indices of
  /// the scene, SceneNotes those of the surface.
  std::uint32_t facet = 0;
  std::uint32_t other = 0;
  double gap = 0.0;    ///< Its width, in the data's unit.
  double offset = 0.0; ///< How far rays start from a facet there, in the data's unit.
  /// Facets too small for the rays there: their longest edge is no longer than eight offsets.
  std::size_t unresolved = 0;
  std::uint32_t firstUnresolved = 0;

  /// Adds what was found among facets after these.
  void Add(const ThinGaps& later);
};

ThinGaps FindThinGaps(const Scene& scene);

} // namespace PhotonTransport
