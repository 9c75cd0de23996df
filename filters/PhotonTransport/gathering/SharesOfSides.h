// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellSides.h"
#include "PhotonTransport/gathering/DiffuseShares.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What sides of cells send back and let through diffusely, by the materials of their facets.
class SharesOfSides
{
public:
  /// @param scene Must outlive it, as the cells must.
  SharesOfSides(const Scene& scene, const FacetCells& cells, const Effects& effects)
    : LitScene(scene)
    , Cells(cells)
    , OfMaterials(SharesOf(scene.Materials(), effects))
    , SomeAreBlack(std::any_of(this->OfMaterials.begin(), this->OfMaterials.end(),
        [](const DiffuseShares& shares) { return shares.IsBlack(); }))
  {
  }

  const DiffuseShares& Of(std::uint32_t side) const
  {
    return this->OfMaterials[this->LitScene.MaterialOfFacet()[this->Cells.FacetOf(CellOf(side))]];
  }
  /// The facet of a cell takes a search, which is left out where no material is black.
  bool IsBlack(std::uint32_t side) const { return this->SomeAreBlack && this->Of(side).IsBlack(); }

private:
  const Scene& LitScene;
  const FacetCells& Cells;
  std::vector<DiffuseShares> OfMaterials;
  bool SomeAreBlack;
};

} // namespace PhotonTransport
