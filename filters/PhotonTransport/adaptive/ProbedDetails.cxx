// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/ProbedDetails.h"

#include <algorithm>
#include <utility>

namespace PhotonTransport
{

void ProbedDetails::AddDetails(const LitMesh& mesh, const std::vector<double>& misses)
{
  for (std::size_t edge = 0; edge < misses.size(); ++edge)
  {
    if (!(misses[edge] > 0.0))
    {
      continue;
    }
    mesh.Mesh().Edges().ForEachSide(edge,
      [&](const FacetEdge& at)
      {
        std::uint32_t i = this->DivisionOfFacet[at.facet];
        while (i != None && !this->Divisions[i].isNeeded)
        {
          this->Divisions[i].isNeeded = true;
          i = this->Divisions[i].before;
        }
      });
  }
}

void ProbedDetails::Halve(LitMesh& mesh, const LitMesh::Marks& marks)
{
  const MeshEdges& edges = mesh.Mesh().Edges();
  for (std::size_t f = 0; f < this->DivisionOfFacet.size(); ++f)
  {
    Division division{ this->DivisionOfFacet[f], {}, false };
    bool isDivided = false;
    for (std::size_t side = 0; side < 3; ++side)
    {
      const bool isHalved = marks[edges.EdgeOf(f, side)] != 0;
      division.middles[side] =
        isHalved ? mesh.MiddleOf(edges.Pairs()[edges.PairOf(f, side)]) : LitMesh::NoSample;
      isDivided = isDivided || isHalved;
    }
    if (isDivided)
    {
      this->DivisionOfFacet[f] = static_cast<std::uint32_t>(this->Divisions.size());
      this->Divisions.push_back(division);
    }
  }
  std::vector<std::uint32_t> ofParts = mesh.Halve(marks);
  for (std::uint32_t& part : ofParts)
  {
    part = this->DivisionOfFacet[part];
  }
  this->DivisionOfFacet = std::move(ofParts);
}

std::vector<std::uint8_t> ProbedDetails::NeededMiddles(std::size_t samples) const
{
  std::vector<std::uint8_t> needed(samples, 0);
  for (const Division& division : this->Divisions)
  {
    for (const std::uint32_t middle : division.middles)
    {
      if (division.isNeeded && middle != LitMesh::NoSample)
      {
        needed[middle] = 1;
      }
    }
  }
  return needed;
}

} // namespace PhotonTransport
