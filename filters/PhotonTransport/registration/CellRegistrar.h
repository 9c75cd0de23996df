// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/registration/Registrar.h"

namespace PhotonTransport
{

/// Counts photons, each with the same flux, by the cells of facets where they arrive. At vertices
/// it registers caustics alone, since the second pass brings all other light there.
template <Registration RegistrationKind, bool BackSide>
class CellRegistrar
{
public:
  /// @param startWeights [source] By which each photon counts at vertices; must outlive it.
  CellRegistrar(const Scene& scene, const FacetCells& cells, float weightBound,
    IlluminationSums& sums, const float* startWeights)
    : Cells(cells)
    , Counts(sums.cells)
    , LampCells(sums.layers.lampCells)
    , AtVertices(scene, weightBound, sums, startWeights)
  {
  }

  void operator()(const Ray& ray, const Hit& hit, bool front, const PhotonOrigin& photon,
    unsigned corners = AllCorners) const
  {
    if (photon.IsCaustic())
    {
      this->AtVertices(ray, hit, front, photon, corners);
    }
  }

  void Arrived(const Hit& hit, bool front, const PhotonOrigin& photon) const
  {
    const std::uint32_t cell = this->Cells.At(hit.facet, hit.barycentric);
    const std::size_t place =
      this->Counts.PlaceOf(cell, front) + (this->Counts.channels > 1 ? photon.channel : 0u);
    const bool isCaustic = photon.IsCaustic() && !this->Counts.caustic.empty();
    ++this->Counts.all[place];
    if (isCaustic)
    {
      ++this->Counts.caustic[place];
    }
    if (!this->LampCells.IsEmpty())
    {
      const std::size_t ofLamp = place * this->LampCells.lamps + photon.source;
      ++this->LampCells.all[ofLamp];
      if (isCaustic)
      {
        ++this->LampCells.caustic[ofLamp];
      }
    }
  }

  [[gnu::always_inline]] inline void Prefetch(const Hit& hit) const
  {
    if (hit)
    {
      const std::uint32_t cell = this->Cells.At(hit.facet, hit.barycentric);
      __builtin_prefetch(&this->Counts.all[this->Counts.PlaceOf(cell, true)], 1);
    }
  }

private:
  const FacetCells& Cells;
  CellCounts& Counts;
  LampCellCounts& LampCells;
  Registrar<RegistrationKind, BackSide> AtVertices;
};

} // namespace PhotonTransport
