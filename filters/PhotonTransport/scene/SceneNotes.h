// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/ScatteringSet.h"
#include "PhotonTransport/scene/SharedPlace.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// Gaps too thin for the rays there. A ray starts a little above the facet that it leaves
/// (OriginOffset); if another facet is nearer than that, light passes through it. A gap counts only
/// where light may be in it: in front of both facets, or beside one that lets light through. A
/// facet nearer than an eighth of the offset, or than the rounding of the data explains, is taken
/// to be in the same place, unless the facet that the ray leaves is the surface of a solid body.
/// Facets that share a point are not compared.
struct ThinGaps
{
  /// Facets that have such a gap at their middle; one that lets light through counts for each side
  /// that has one.
  std::size_t number = 0;
  /// The two facets of the thinnest gap, in the surface's list; of several equal gaps the first.
  std::uint32_t facet = 0;
  std::uint32_t other = 0;
  double gap = 0.0;    ///< Its width, in the data's unit.
  double offset = 0.0; ///< How far rays start from a facet there, in the data's unit.
  /// Facets too small for the rays there: their longest edge is shorter than eight offsets.
  std::size_t unresolved = 0;
  std::uint32_t firstUnresolved = 0; ///< In the surface's list.
};

/// Something that was found at places of the surface.
struct Finding
{
  std::size_t number = 0;
  std::size_t first = 0; ///< Index in the Surface.
  void Add(std::size_t index) { this->first = this->number++ == 0 ? index : this->first; }
};

/// What was found in the surface and mended while it was prepared.
struct SceneNotes
{
  std::size_t turnedFacets = 0;    ///< The normals contradict the winding and tell the front.
  std::size_t droppedFacets = 0;   ///< No area that a float can hold: they can't be hit.
  std::size_t replacedNormals = 0; ///< Zero or not finite: the ring's mean normal instead.
  Finding undecidedFacets;         ///< The winding tells the front, normals do not (FacetSide).
  Finding inPlaneNormals;          ///< In the plane of all facets of the point: replaced, too.
  std::size_t tiltedVertices = 0;  ///< Normal differs from some facet's around it.
  /// Facets that scatter light in each way, by Scattering.
  std::array<std::size_t, Scatterings> scatteringFacets{};
  ThinGaps thinGaps;
  SharedPlaceNotes sharedPlaces;
  std::size_t curvedFacets = 0;   ///< Given facets that a refined surface has in several parts.
  double turn = 0.0;              ///< See GivenSurface.
  bool isCoarse = false;          ///< See GivenSurface.
  std::size_t colouredFacets = 0; ///< See IsColoured.
};

} // namespace PhotonTransport
