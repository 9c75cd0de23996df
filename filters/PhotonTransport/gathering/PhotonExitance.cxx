// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/PhotonExitance.h"

#include "PhotonTransport/gathering/DiffuseShares.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

namespace PhotonTransport
{
namespace
{

std::vector<double> SharesOfReplicates(const PhotonCounts& counts)
{
  const double photons = counts.Photons();
  std::vector<double> shares;
  for (const ReplicateCounts& replicate : counts.replicates)
  {
    shares.push_back(photons > 0.0 ? replicate.photons / photons : 0.0);
  }
  return shares;
}

double PerPhoton(double value, double photons)
{
  return photons > 0.0 ? value / photons : 0.0;
}

/// Fills in one side of a cell.
class SideOfCell
{
public:
  /// @param area Of the cell, scene units squared.
  SideOfCell(const PhotonCounts& counts, const DiffuseShares& shares, std::uint32_t cell,
    bool front, double area)
    : Counts(counts)
    , Shares(shares)
    , Own(counts.replicates.front().cells->PlaceOf(cell, front))
    , Other(counts.replicates.front().cells->PlaceOf(cell, !front))
    , PerArea(1.0 / area)
  {
  }

  void Fill(CellExitance& exitance, std::size_t side) const
  {
    float* leaving = exitance.leaving.Of(side);
    float* caustic = exitance.caustic.Of(side);
    double mean = 0.0;
    for (std::size_t r = 0; r < exitance.Replicates(); ++r)
    {
      const ReplicateCounts& replicate = this->Counts.replicates[r];
      // E = flux / N * count / area, in units of the flux on a scene unit squared; Jensen,
      // "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 7, with a cell in place of
      // a disk.
      const double light = this->PerCount(replicate.photons);
      for (std::size_t c = 0; c < exitance.channels; ++c)
      {
        const double here = replicate.cells->all[this->Own + c];
        *leaving++ = this->Leaves(c, light * here, light * replicate.cells->all[this->Other + c]);
        if (caustic)
        {
          *caustic++ = static_cast<float>(light * replicate.cells->caustic[this->Own + c]);
        }
        mean += exitance.shareOf[r] * light * here;
      }
    }
    exitance.illuminance[side] = static_cast<float>(mean);
    this->FillByLamp(exitance, side);
  }

private:
  double PerCount(double photons) const
  {
    return PerPhoton(this->PerArea, photons) / this->Counts.replicates.front().cells->OfPhoton();
  }

  void FillByLamp(CellExitance& exitance, std::size_t side) const
  {
    const LampCellCounts& counts = this->Counts.lamps;
    const double light = this->PerCount(this->Counts.Photons());
    const std::size_t own = this->Own * exitance.lamps;
    const std::size_t other = this->Other * exitance.lamps;
    float* leaving = exitance.leavingByLamp.Of(side);
    float* caustic = exitance.causticByLamp.Of(side);
    for (std::size_t i = 0; i < exitance.channels * exitance.lamps; ++i)
    {
      leaving[i] = this->Leaves(
        i / exitance.lamps, light * counts.all[own + i], light * counts.all[other + i]);
      if (caustic)
      {
        caustic[i] = static_cast<float>(light * counts.caustic[own + i]);
      }
    }
  }

  float Leaves(std::size_t channel, double here, double beyond) const
  {
    const int c = static_cast<int>(channel);
    return static_cast<float>(
      double{ this->Shares.reflected[c] } * here + double{ this->Shares.through[c] } * beyond);
  }

  const PhotonCounts& Counts;
  const DiffuseShares& Shares;
  std::size_t Own, Other; ///< Places in the counts.
  double PerArea;
};

} // namespace

double PhotonCounts::CountOn(std::uint32_t cell, bool front) const
{
  double sum = 0.0;
  for (const ReplicateCounts& replicate : this->replicates)
  {
    const std::size_t place = replicate.cells->PlaceOf(cell, front);
    for (std::size_t c = 0; c < replicate.cells->channels; ++c)
    {
      sum += replicate.cells->all[place + c];
    }
  }
  return sum / this->replicates.front().cells->OfPhoton();
}

CellExitance ExitanceByPhotons(
  const Scene& scene, const FacetCells& cells, const Effects& effects, const PhotonCounts& counts)
{
  const CellCounts& first = *counts.replicates.front().cells;
  CellExitance exitance(cells.Number(), SharesOfReplicates(counts), first.channels,
    counts.lamps.lamps, !first.caustic.empty());
  const std::vector<DiffuseShares> shares = SharesOf(scene.Materials(), effects);
  ForEach(scene.Facets().size(),
    [&](std::size_t f)
    {
      const auto facet = static_cast<std::uint32_t>(f);
      const double area = glm::length(glm::dvec3(scene.AreaVectors()[f]));
      cells.ForEachOf(facet,
        [&](std::uint32_t cell, double share)
        {
          for (const bool front : { true, false })
          {
            SideOfCell(counts, shares[scene.MaterialOfFacet()[f]], cell, front, share * area)
              .Fill(exitance, SideIndex(cell, front));
          }
        });
    });
  return exitance;
}

} // namespace PhotonTransport
