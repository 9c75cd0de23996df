// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

class Scene;

/// Gaps too thin for the rays there. A ray starts a little above the facet that it leaves
/// (OriginOffset); if another facet is nearer than that, light passes it unseen. A gap counts only
/// where light may be in it: in front of both facets, or beside one that lets light through. A
/// facet nearer than an eighth of the offset, or than the rounding of the data explains, is taken
/// to be in the same place, unless the facet that the ray leaves is the surface of a solid body.
/// Facets that share a point are not compared.
struct ThinGaps
{
  /// Facets that have such a gap at their middle; one that lets light through counts for each side
  /// that has one.
  std::size_t number = 0;
  /// The two facets of the thinnest gap; of several equal gaps the first in the list. FindThinGaps
  /// gives indices of the scene, SceneNotes those of the surface.
  std::uint32_t facet = 0;
  std::uint32_t other = 0;
  double gap = 0.0;    ///< Its width, in the data's unit.
  double offset = 0.0; ///< How far rays start from a facet there, in the data's unit.
  /// Facets too small for the rays there: their longest edge is shorter than eight offsets.
  std::size_t unresolved = 0;
  std::uint32_t firstUnresolved = 0;

  /// Adds what was found among facets that come later in the list.
  void Add(const ThinGaps& later);
};

ThinGaps FindThinGaps(const Scene& scene);

} // namespace PhotonTransport
