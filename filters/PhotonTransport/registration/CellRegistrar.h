// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/registration/Registrar.h"
#include "PhotonTransport/sampling/PhotonSample.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

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
    const std::size_t place =
      this->Counts.PlaceOf(this->Cells.At(hit.facet, hit.barycentric), front);
    if (this->Counts.channels == 1)
    {
      this->Add(place, 1, photon);
      return;
    }
    const std::array<std::uint32_t, 3> parts = PartsOf(photon.shares, hit);
    for (std::size_t c = 0; c < parts.size(); ++c)
    {
      this->Add(place + c, parts[c], photon);
    }
  }

  /// See Registrar.
  void Finish() const { this->AtVertices.Finish(); }

  [[gnu::always_inline]] inline void Prefetch(const Hit& hit) const
  {
    if (hit)
    {
      const std::uint32_t cell = this->Cells.At(hit.facet, hit.barycentric);
      __builtin_prefetch(&this->Counts.all[this->Counts.PlaceOf(cell, true)], 1);
    }
  }

private:
  /// Whole numbers that add up to CellCounts::OfColours and are on average those shares of it. Up
  /// or down is decided by the last bits of the place, which say nothing of anything else.
  static std::array<std::uint32_t, 3> PartsOf(const Colour& shares, const Hit& hit)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &hit.barycentric.y, sizeof(bits));
    constexpr std::uint32_t Spread = 2654435769u; // 2^32 over the golden ratio
    const float rounding = UnitFloat(bits * Spread);
    constexpr auto All = static_cast<float>(CellCounts::OfColours);
    const auto end = [&](float share)
    { return std::min(CellCounts::OfColours, static_cast<std::uint32_t>(share * All + rounding)); };
    const std::uint32_t green = end(shares.y);
    const std::uint32_t greenAndBlue = std::max(green, end(shares.y + shares.z));
    return { CellCounts::OfColours - greenAndBlue, green, greenAndBlue - green };
  }

  void Add(std::size_t place, std::uint32_t count, const PhotonOrigin& photon) const
  {
    const bool isCaustic = photon.IsCaustic() && !this->Counts.caustic.empty();
    this->Counts.all[place] += count;
    if (isCaustic)
    {
      this->Counts.caustic[place] += count;
    }
    if (!this->LampCells.IsEmpty())
    {
      const std::size_t ofLamp = place * this->LampCells.lamps + photon.source;
      this->LampCells.all[ofLamp] += count;
      if (isCaustic)
      {
        this->LampCells.caustic[ofLamp] += count;
      }
    }
  }

  const FacetCells& Cells;
  CellCounts& Counts;
  LampCellCounts& LampCells;
  Registrar<RegistrationKind, BackSide> AtVertices;
};

} // namespace PhotonTransport
