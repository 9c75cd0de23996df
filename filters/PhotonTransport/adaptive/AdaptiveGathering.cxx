// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/AdaptiveGathering.h"

#include "PhotonTransport/adaptive/ProbedDetails.h"
#include "PhotonTransport/gathering/CellLengths.h"
#include "PhotonTransport/geometry/FacetRings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <tuple>

namespace PhotonTransport
{
namespace
{

/// The mesh that only looks has edges of at most so many lengths that cells should have: with their
/// middles light is looked at once a cell.
constexpr double LongestInCells = 2.0;

/// No edge is made shorter than this share of the longest edges of the mesh that looks.
/// Interpolation misses a hard shadow's border by half of the step, however short the edges are.
/// The RMS error over the surface falls as the square root of their length, so they are as short as
/// the square of the tolerance. For a shadow that is a fifth of a floor it then is within it.
double ShortestShare(double tolerance)
{
  constexpr double Factor = 8.0, Least = 0x1p-12, Most = 0x1p-3;
  return std::clamp(Factor * tolerance * tolerance, Least, Most);
}

/// Relative to the mean light, what is darker counts as bright as this: a tolerance relative to
/// nearly nothing would divide what no one can see.
constexpr double DarkestShare = 0.1;

/// The mean light on one side of all facets, by what the first pass has counted, lx.
double MeanLight(const Scene& scene, const FacetCells& cells, const GatherPass& pass, bool front)
{
  double flux = 0.0;
  double area = 0.0;
  for (std::uint32_t f = 0; f < scene.Facets().size(); ++f)
  {
    const double ofFacet = glm::length(scene.AreaVectors()[f]);
    cells.ForEachOf(f,
      [&](std::uint32_t cell, double share)
      { flux += share * ofFacet * pass.IlluminanceOf(cell, front); });
    area += ofFacet;
  }
  return flux / area;
}

} // namespace

bool AdaptiveGathering::Wish::operator<(const Wish& other) const
{
  return std::tuple(!this->first, -this->miss, -this->length, this->edge) <
    std::tuple(!other.first, -other.miss, -other.length, other.edge);
}

AdaptiveGathering::AdaptiveGathering(const AdaptiveStart& start, const AdaptiveLimits& limits)
  : Start(start)
  , Limits(limits)
  , Receivers(start.scene, start.surface, start.cells)
  , Lengths(start.surface.facets.size(), std::numeric_limits<double>::infinity())
  , Samples{ LightSamples(start.front, start.back), {} }
{
  Validate(limits);
}

GatheredMap AdaptiveGathering::Front() const
{
  return this->Samples.light.Front(this->Result->SampleOfPoint());
}

GatheredMap AdaptiveGathering::Back() const
{
  return this->Samples.light.Back(this->Result->SampleOfPoint());
}

bool AdaptiveGathering::Run(const GatherPass& pass, const GatherPass::Report& report)
{
  this->MeasureFacets();
  this->MeasureLight(pass);
  if (!this->ReceivePoints(pass, report))
  {
    return false;
  }
  const bool goOn = this->Probe(pass, report);
  this->Result.emplace(
    LitMesh::Parts{ this->Start.surface, this->Receivers, this->Lengths, this->Samples });
  if (goOn)
  {
    this->Refine(pass, report);
  }
  this->Most = std::max(this->Most, this->Mesh().Facets().size());
  return true;
}

/// Light varies at the scale of what a registered side sees. Cells are for both sides, so these
/// lengths are not theirs: the inside of a closed body is small.
void AdaptiveGathering::MeasureFacets()
{
  const std::vector<float> lengths =
    CellLengths(this->Start.scene, !this->Start.back.direct.empty());
  const double toData = 1.0 / this->Start.scene.GetPlacement().scale;
  for (std::uint32_t f = 0; f < this->Lengths.size(); ++f)
  {
    const std::uint32_t inScene = this->Receivers.InScene(f);
    if (inScene != NoFacet)
    {
      this->Lengths[f] = LongestInCells * double{ lengths[inScene] } * toData;
    }
  }
}

void AdaptiveGathering::MeasureLight(const GatherPass& pass)
{
  const auto darkest = [&](bool front)
  { return DarkestShare * MeanLight(this->Start.scene, this->Start.cells, pass, front); };
  this->Darkest = { darkest(true), darkest(false) };
}

/// Light at those points of the surface that are no vertices of the map.
bool AdaptiveGathering::ReceivePoints(const GatherPass& pass, const GatherPass::Report& report)
{
  const std::size_t vertices = this->Samples.light.Number();
  const Surface& surface = this->Start.surface;
  const FacetRings rings(surface.points.size(), surface.facets);
  const auto make = [&](std::size_t i, bool front, Receiver& receiver)
  {
    const auto point = static_cast<std::uint32_t>(vertices + i);
    std::vector<PlaceOnFacet> places;
    for (const std::uint32_t f : rings.Of(point))
    {
      glm::vec3 at(0.0f);
      for (int c = 0; c < 3; ++c)
      {
        at[c] = surface.facets[f][c] == point ? 1.0f : 0.0f;
      }
      places.push_back({ f, at, WholeFacet });
    }
    this->Receivers.Make(places, front, receiver);
  };
  return this->Samples.light.Add(surface.points.size() - vertices, make, pass, report);
}

/// Looks for details with a mesh whose edges are short everywhere.
bool AdaptiveGathering::Probe(const GatherPass& pass, const GatherPass::Report& report)
{
  LitMesh mesh({ this->Start.surface, this->Receivers, this->Lengths, this->Samples });
  ProbedDetails details(mesh);
  bool full = false;
  for (bool goOn = true; goOn;)
  {
    if (!mesh.ReceiveMiddles(this->LongEnough(mesh), pass, report))
    {
      return false;
    }
    details.AddDetails(mesh, mesh.Misses(this->Limits.tolerance, this->Darkest));
    const std::vector<Wish> wishes = this->TooLong(mesh);
    goOn = !wishes.empty() && !full;
    if (goOn)
    {
      const Marks marks = this->MarksFor(wishes, mesh.Mesh(), full);
      if (!mesh.ReceiveMiddles(marks, pass, report))
      {
        return false;
      }
      details.Halve(mesh, marks);
    }
  }
  this->Needed = details.NeededMiddles(this->Samples.light.Number());
  this->Most = mesh.Mesh().Facets().size();
  return true;
}

void AdaptiveGathering::Refine(const GatherPass& pass, const GatherPass::Report& report)
{
  LitMesh& mesh = *this->Result;
  while (!this->Full && mesh.ReceiveMiddles(this->LongEnough(mesh), pass, report))
  {
    const std::vector<Wish> wishes = this->Missing(mesh);
    if (wishes.empty())
    {
      return;
    }
    const Marks marks = this->MarksFor(wishes, mesh.Mesh(), this->Full);
    if (!mesh.ReceiveMiddles(marks, pass, report))
    {
      return;
    }
    mesh.Halve(marks);
  }
}

/// Edges that may be halved.
AdaptiveGathering::Marks AdaptiveGathering::LongEnough(const LitMesh& mesh) const
{
  const double shortest = 2.0 * ShortestShare(this->Limits.tolerance);
  Marks marks(mesh.Mesh().Edges().Number());
  for (std::size_t edge = 0; edge < marks.size(); ++edge)
  {
    marks[edge] = mesh.Mesh().Length(edge) > shortest * mesh.LengthOf(edge) ? 1 : 0;
  }
  return marks;
}

std::vector<AdaptiveGathering::Wish> AdaptiveGathering::TooLong(const LitMesh& mesh) const
{
  std::vector<Wish> wishes;
  for (std::uint32_t edge = 0; edge < mesh.Mesh().Edges().Number(); ++edge)
  {
    const double length = mesh.Mesh().Length(edge);
    if (length > mesh.LengthOf(edge))
    {
      wishes.push_back({ true, 0.0, length, edge });
    }
  }
  return wishes;
}

/// Edges whose light misses, and those that lead to details, which come first.
std::vector<AdaptiveGathering::Wish> AdaptiveGathering::Missing(const LitMesh& mesh) const
{
  const MeshEdges& edges = mesh.Mesh().Edges();
  std::vector<std::uint8_t> leads(edges.Number(), 0);
  for (const PointPair& pair : edges.Pairs())
  {
    const std::uint32_t middle = mesh.MiddleOf(pair);
    if (middle < this->Needed.size() && this->Needed[middle] != 0)
    {
      leads[pair.edge] = 1;
    }
  }
  const std::vector<double> misses = mesh.Misses(this->Limits.tolerance, this->Darkest);
  std::vector<Wish> wishes;
  for (std::uint32_t edge = 0; edge < misses.size(); ++edge)
  {
    if (leads[edge] != 0 || misses[edge] > 0.0)
    {
      wishes.push_back({ leads[edge] != 0, misses[edge], mesh.Mesh().Length(edge), edge });
    }
  }
  return wishes;
}

/// Marks for all wishes, or for as many as the number of facets allows.
/// @param full Set if these are not all.
AdaptiveGathering::Marks AdaptiveGathering::MarksFor(
  std::vector<Wish> wishes, const AdaptiveMesh& mesh, bool& full) const
{
  std::sort(wishes.begin(), wishes.end());
  const auto marksForFirst = [&](std::size_t number)
  {
    Marks marks(mesh.Edges().Number(), 0);
    for (std::size_t i = 0; i < number; ++i)
    {
      marks[wishes[i].edge] = 1;
    }
    mesh.Close(marks);
    return marks;
  };
  Marks marks = marksForFirst(wishes.size());
  if (mesh.FacetsAfter(marks) <= this->Limits.facets)
  {
    return marks;
  }
  full = true;
  std::size_t fit = 0, tooMany = wishes.size();
  while (fit + 1 < tooMany)
  {
    const std::size_t middle = fit + (tooMany - fit) / 2;
    const bool fits = mesh.FacetsAfter(marksForFirst(middle)) <= this->Limits.facets;
    (fits ? fit : tooMany) = middle;
  }
  return marksForFirst(fit);
}

} // namespace PhotonTransport
