// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/LitMesh.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace PhotonTransport
{
namespace
{

std::uint64_t KeyOf(std::uint32_t a, std::uint32_t b)
{
  return std::uint64_t{ std::min(a, b) } << 32 | std::max(a, b);
}

TriangleMesh MeshOf(const Surface& surface)
{
  return { surface.points, surface.normals, surface.facets, surface.rounding };
}

} // namespace

LitMesh::LitMesh(const Parts& parts)
  : From(parts)
  , Refined(MeshOf(parts.surface))
  , Samples(parts.surface.points.size())
{
  std::iota(this->Samples.begin(), this->Samples.end(), 0u);
  this->MeasureEdges();
}

void LitMesh::MeasureEdges()
{
  const MeshEdges& edges = this->Refined.Edges();
  this->Lengths.assign(edges.Number(), std::numeric_limits<double>::infinity());
  for (std::size_t edge = 0; edge < edges.Number(); ++edge)
  {
    double& length = this->Lengths[edge];
    edges.ForEachSide(edge,
      [&](const FacetEdge& at)
      { length = std::min(length, this->From.lengths[this->Refined.Origins()[at.facet].facet]); });
  }
}

std::uint32_t LitMesh::MiddleOf(const PointPair& pair) const
{
  const auto found =
    this->From.samples.middles.find(KeyOf(this->Samples[pair.from], this->Samples[pair.to]));
  return found != this->From.samples.middles.end() ? found->second : NoSample;
}

bool LitMesh::ReceiveMiddles(
  const Marks& ofEdges, const GatherPass& pass, const GatherPass::Report& report)
{
  const std::vector<PointPair>& pairs = this->Refined.Edges().Pairs();
  std::vector<std::uint32_t> without;
  for (std::uint32_t i = 0; i < pairs.size(); ++i)
  {
    if (ofEdges[pairs[i].edge] != 0 && this->MiddleOf(pairs[i]) == NoSample)
    {
      without.push_back(i);
    }
  }
  SharedSamples& samples = this->From.samples;
  const std::size_t first = samples.light.Number();
  const auto make = [&](std::size_t i, bool front, Receiver& receiver)
  {
    std::vector<PlaceOnFacet> places;
    this->PlacesOfMiddle(without[i], places);
    this->From.receivers.Make(places, front, receiver);
  };
  if (!samples.light.Add(without.size(), make, pass, report))
  {
    return false;
  }
  for (std::size_t i = 0; i < without.size(); ++i)
  {
    const PointPair& pair = pairs[without[i]];
    samples.middles[KeyOf(this->Samples[pair.from], this->Samples[pair.to])] =
      static_cast<std::uint32_t>(first + i);
  }
  return true;
}

void LitMesh::PlacesOfMiddle(std::uint32_t pair, std::vector<PlaceOnFacet>& places) const
{
  const MeshEdges& edges = this->Refined.Edges();
  edges.ForEachSide(edges.Pairs()[pair].edge,
    [&](const FacetEdge& at)
    {
      if (edges.PairOf(at.facet, at.side) == pair)
      {
        const FacetOrigin& origin = this->Refined.Origins()[at.facet];
        places.push_back({ origin.facet,
          0.5f * (origin.corners[(at.side + 1) % 3] + origin.corners[(at.side + 2) % 3]),
          origin.corners });
      }
    });
}

std::vector<double> LitMesh::Misses(double tolerance, const LightSamples::Floor& darkest) const
{
  std::vector<double> misses(this->Refined.Edges().Number(), 0.0);
  for (const PointPair& pair : this->Refined.Edges().Pairs())
  {
    const std::uint32_t middle = this->MiddleOf(pair);
    if (middle != NoSample)
    {
      const double miss = this->From.samples.light.Miss(
        this->Samples[pair.from], middle, this->Samples[pair.to], tolerance, darkest);
      misses[pair.edge] = std::max(misses[pair.edge], miss);
    }
  }
  return misses;
}

std::vector<std::uint32_t> LitMesh::Halve(const Marks& marks)
{
  AdaptiveMesh::Halved halved = this->Refined.Halve(marks);
  for (const PointPair& pair : halved.pairs)
  {
    this->Samples.push_back(this->MiddleOf(pair));
  }
  this->MeasureEdges();
  return std::move(halved.parents);
}

} // namespace PhotonTransport
