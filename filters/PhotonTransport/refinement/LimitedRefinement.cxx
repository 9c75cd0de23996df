// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/LimitedRefinement.h"

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

} // namespace

LimitedRefinement LimitFacets(
  const TriangleMesh& mesh, const RefinementLimits& limits, std::uint64_t most)
{
  LimitedRefinement result{ std::make_unique<Refinement>(mesh), limits, false };
  Refinement& refinement = *result.refinement;
  if (mesh.facets.size() >= most)
  {
    result.limits = {};
    result.widened = refinement.FacetsAtMost(limits) > mesh.facets.size();
    refinement.Divide(result.limits);
    return result;
  }
  int saved = 0; // halvings, so many that there are surely no more facets than allowed
  while (refinement.FacetsAtMost(Wider(limits, saved)) > most)
  {
    ++saved;
  }
  // A halving more gives four times as many facets at most.
  for (; saved >= 0; --saved)
  {
    result.limits = Wider(limits, saved);
    result.widened = saved > 0;
    refinement.Divide(result.limits);
    if (3 * refinement.NumberOfFacets() > most)
    {
      break;
    }
  }
  if (refinement.NumberOfFacets() > most)
  {
    result.limits = refinement.Fit(most);
    result.widened = true;
  }
  return result;
}

} // namespace PhotonTransport
