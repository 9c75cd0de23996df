// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/LimitedRefinement.h"

#include "PhotonTransport/refinement/EdgeCurves.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Limits by which edges are halved so many times less.
RefinementLimits Wider(RefinementLimits limits, int halvings)
{
  limits.length = std::ldexp(limits.length, halvings);
  limits.turn = std::ldexp(limits.turn, halvings);
  limits.sagitta = std::ldexp(limits.sagitta, 2 * halvings);
  return limits;
}

/// How many facets there were if each was divided as finely everywhere as at its finest edge.
std::uint64_t MostFacets(const TriangleMesh& mesh, const MeshEdges& edges, const EdgeCurves& curves)
{
  std::uint64_t sum = 0;
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    int halvings = 0;
    for (std::size_t side = 0; side < 3; ++side)
    {
      halvings = std::max(halvings, curves[edges.EdgeOf(f, side)].halvings);
    }
    sum += std::uint64_t{ 1 } << (2 * halvings);
  }
  return sum;
}

/// How many halvings less are sure to give no more facets than `most`, which is more than the mesh
/// has.
int HalvingsToSave(const TriangleMesh& mesh, const RefinementLimits& limits, std::uint64_t most)
{
  const MeshEdges edges(mesh);
  EdgeCurves curves(mesh, edges);
  int halvings = 0;
  curves.Divide(limits);
  while (MostFacets(mesh, edges, curves) > most)
  {
    curves.Divide(Wider(limits, ++halvings));
  }
  return halvings;
}

} // namespace

LimitedRefinement LimitFacets(
  const TriangleMesh& mesh, const RefinementLimits& limits, std::uint64_t most)
{
  LimitedRefinement result{ nullptr, limits, false };
  if (mesh.facets.size() >= most)
  {
    result.limits = {};
    result.refinement = std::make_unique<Refinement>(mesh, result.limits);
    const MeshEdges edges(mesh);
    EdgeCurves curves(mesh, edges);
    curves.Divide(limits);
    result.widened = MostFacets(mesh, edges, curves) > mesh.facets.size();
    return result;
  }
  // A halving more gives four times as many facets at most.
  for (int saved = HalvingsToSave(mesh, limits, most); saved >= 0; --saved)
  {
    result.limits = Wider(limits, saved);
    result.widened = saved > 0;
    result.refinement = std::make_unique<Refinement>(mesh, result.limits);
    if (3 * result.refinement->NumberOfFacets() > most)
    {
      break;
    }
  }
  if (result.refinement->NumberOfFacets() > most)
  {
    result.limits = result.refinement->Fit(most);
    result.widened = true;
  }
  return result;
}

} // namespace PhotonTransport
