// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/geometry/FacetRings.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstdint>

namespace PhotonTransport
{

/// The vertices of a map as receivers.
class VertexReceivers
{
public:
  /// Both must outlive it. @param cells In which the light on facets is known.
  VertexReceivers(const Scene& scene, const FacetCells& cells);

  /// The receiver on one side of a vertex; without starts where the vertex has no area. Rays start
  /// a little within the facets around it: those from a vertex in a room's edge would lie in the
  /// other wall's plane and leave the room.
  void Make(std::uint32_t vertex, bool front, Receiver& receiver) const;

  const FacetRings& Rings() const { return this->FacetsAround; }

private:
  const Scene& LitScene;
  const FacetCells& Cells;
  FacetRings FacetsAround; ///< Of the facets that are traced; those of patches are parts.
};

} // namespace PhotonTransport
