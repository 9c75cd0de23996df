// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/registration/CellCounts.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"

#include <vector>

namespace PhotonTransport
{

/// What one replicate of the photons has counted.
struct ReplicateCounts
{
  const CellCounts* cells;
  double photons; ///< Emitted; may be 0.
};

/// All that photons have counted.
struct PhotonCounts
{
  std::vector<ReplicateCounts> replicates;
  const LampCellCounts& lamps; ///< Of each lamp over all replicates; or empty.

  double Photons() const
  {
    double photons = 0.0;
    for (const ReplicateCounts& replicate : this->replicates)
    {
      photons += replicate.photons;
    }
    return photons;
  }
  /// Of all replicates, on a side.
  double CountOn(std::uint32_t cell, bool front) const;
};

/// The exitance that photons tell of, in units of their flux per scene unit squared.
CellExitance ExitanceByPhotons(
  const Scene& scene, const FacetCells& cells, const Effects& effects, const PhotonCounts& counts);

} // namespace PhotonTransport
