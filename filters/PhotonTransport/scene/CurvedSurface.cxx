// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/CurvedSurface.h"

#include "PhotonTransport/refinement/LimitedRefinement.h"

#include <glm/trigonometric.hpp>

#include <utility>

namespace PhotonTransport
{
namespace
{

template <typename Element>
std::vector<Element> OfParts(
  const std::vector<Element>& ofFacets, const std::vector<FacetOrigin>& origins)
{
  std::vector<Element> ofParts;
  if (!ofFacets.empty())
  {
    ofParts.reserve(origins.size());
    for (const FacetOrigin& origin : origins)
    {
      ofParts.push_back(ofFacets[origin.facet]);
    }
  }
  return ofParts;
}

} // namespace

Surface CurvedSurface(Surface surface, std::uint64_t mostFacets)
{
  Validate(surface);
  RefinementLimits limits;
  limits.turn = glm::radians(7.0);
  const LimitedRefinement limited = LimitFacets(
    { surface.points, surface.normals, surface.facets, surface.rounding }, limits, mostFacets);
  surface.given.isCoarse = limited.widened;
  if (limited.refinement->IsTrivial())
  {
    return surface;
  }
  RefinedMesh mesh = limited.refinement->Make();
  surface.given.points = surface.points.size();
  surface.given.turn = limited.limits.turn;
  surface.given.facets = std::move(surface.facets);
  surface.facets = std::move(mesh.facets);
  surface.points = std::move(mesh.points);
  surface.normals.resize(surface.points.size(), glm::dvec3(0.0));
  surface.materialOfFacet = OfParts(surface.materialOfFacet, mesh.origins);
  surface.exitance = OfParts(surface.exitance, mesh.origins);
  surface.openingOfFacet = OfParts(surface.openingOfFacet, mesh.origins);
  surface.given.origins = std::move(mesh.origins);
  return surface;
}

} // namespace PhotonTransport
