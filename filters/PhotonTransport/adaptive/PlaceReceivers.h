// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/refinement/Subdivision.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/Surface.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A point of a part of a facet.
struct PlaceOnFacet
{
  std::uint32_t facet; ///< Of the surface.
  glm::vec3 barycentric;
  FacetTriangle part; ///< That has the point.
};

/// Points of the surface that is traced, anywhere on facets and their edges, as receivers.
class PlaceReceivers
{
public:
  /// @param surface That of the scene. All but it must outlive this.
  PlaceReceivers(const Scene& scene, const Surface& surface, const FacetCells& cells);

  /// The receiver on one side of a point. Its normal is interpolated between those of the given
  /// facet's corners. @param places The same point on each facet that has it: on one if it lies
  /// within, on several if it lies on an edge, where rays start a little within each of them:
  /// a thousandth of a part, or of a cell where that is shorter.
  void Make(const std::vector<PlaceOnFacet>& places, bool front, Receiver& receiver) const;

  /// The scene's index of a facet of the surface; NoFacet if the scene has left it out.
  std::uint32_t InScene(std::uint32_t facet) const { return this->SceneFacets[facet]; }

private:
  glm::vec3 NormalAt(std::uint32_t sceneFacet, const glm::vec3& barycentric) const;

  ReceiverStart StartWithin(
    std::uint32_t sceneFacet, const PlaceOnFacet& place, bool onEdge, bool front) const;

  const Scene& LitScene;
  const FacetCells& Cells;
  std::vector<std::uint32_t> SceneFacets;
};

} // namespace PhotonTransport
