// SPDX-License-Identifier: BSD-3-Clause
// How a run refines its map.
#include "PhotonTransport/transport/RefinedMap.h"

#include "PhotonTransport/adaptive/AdaptiveGathering.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/SecondPass.h"

#include <glm/common.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// A part of a traced facet as a part of the given one.
FacetOrigin InGiven(const FacetOrigin& origin, const Surface& surface)
{
  if (!surface.IsRefined())
  {
    return origin;
  }
  const FacetOrigin& traced = surface.given.origins[origin.facet];
  return { traced.facet,
    { traced.InFacet(origin.corners[0]), traced.InFacet(origin.corners[1]),
      traced.InFacet(origin.corners[2]) } };
}

RefinedMesh MeshOf(const AdaptiveMesh& adaptive, const Surface& surface)
{
  RefinedMesh mesh{ adaptive.Points(), adaptive.Facets(), {} };
  mesh.origins.reserve(mesh.facets.size());
  for (const FacetOrigin& origin : adaptive.Origins())
  {
    mesh.origins.push_back(InGiven(origin, surface));
  }
  return mesh;
}

/// Interpolates what photons have counted, which is a map of the given facets.
class PhotonValues
{
public:
  PhotonValues(const RefinedMesh& mesh, const std::vector<glm::uvec3>& givenFacets)
    : Places(mesh.points.size())
  {
    for (std::size_t f = mesh.facets.size(); f-- > 0;) // the first facet of a point counts
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Places[mesh.facets[f][c]] = { givenFacets[mesh.origins[f].facet],
          glm::dvec3(mesh.origins[f].corners[static_cast<std::size_t>(c)]) };
      }
    }
  }

  std::vector<double> At(const std::vector<double>& ofVertices) const
  {
    std::vector<double> values(ofVertices.empty() ? 0 : this->Places.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      const auto& [ids, shares] = this->Places[p];
      values[p] =
        shares.x * ofVertices[ids.x] + shares.y * ofVertices[ids.y] + shares.z * ofVertices[ids.z];
    }
    return values;
  }

  std::vector<std::array<double, 3>> At(const std::vector<std::array<double, 3>>& ofVertices) const
  {
    std::vector<std::array<double, 3>> values(ofVertices.empty() ? 0 : this->Places.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      const auto& [ids, shares] = this->Places[p];
      for (std::size_t c = 0; c < 3; ++c)
      {
        values[p][c] = shares.x * ofVertices[ids.x][c] + shares.y * ofVertices[ids.y][c] +
          shares.z * ofVertices[ids.z][c];
      }
    }
    return values;
  }

  /// Of the nearest vertex.
  std::vector<std::uint64_t> At(const std::vector<std::uint64_t>& ofVertices) const
  {
    std::vector<std::uint64_t> values(this->Places.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      const auto& [ids, shares] = this->Places[p];
      const int second = shares.y > shares.x ? 1 : 0;
      const int nearest = shares.z > shares[second] ? 2 : second;
      values[p] = shares == glm::dvec3(0.0) ? 0 : ofVertices[ids[nearest]];
    }
    return values;
  }

  IlluminationMap At(const IlluminationMap& map) const
  {
    return { this->At(map.direct), this->At(map.indirect), this->At(map.caustic),
      this->At(map.standardError), this->At(map.photonHits) };
  }

private:
  struct Place
  {
    glm::uvec3 vertices{ 0 };
    glm::dvec3 shares{ 0.0 }; ///< All 0 at a point without a facet.
  };
  std::vector<Place> Places; ///< [point]
};

} // namespace

std::optional<RefinedMap> IlluminationRun::Refine(const Surface& surface,
  const AdaptiveLimits& limits, const std::function<bool(std::uint64_t points)>& monitor)
{
  Validate(limits);
  if (!this->Second || !this->Second->HasGathered(this->Sums))
  {
    return std::nullopt;
  }
  AdaptiveGathering adaptive(
    { this->LitScene, surface, *this->Cells, this->Second->Front(), this->Second->Back() }, limits);
  bool done = false;
  this->Second->Run(
    this->Sums, [&](const GatherPass& pass) { done = adaptive.Run(pass, monitor); });
  if (!done)
  {
    return std::nullopt;
  }
  RefinedMap refined;
  refined.mesh = MeshOf(adaptive.Mesh(), surface);
  refined.isCoarse = adaptive.IsFull();
  refined.mostFacets = adaptive.MostFacets();
  const PhotonValues photons(
    refined.mesh, surface.IsRefined() ? surface.given.facets : surface.facets);
  const GatheredMap front = adaptive.Front();
  const double factor = this->LightFactor;
  refined.front =
    this->Second->Together({ photons.At(this->MapOf(&ReplicateSums::front)), front, factor });
  if (this->Settings.registerBackSide)
  {
    refined.back = this->Second->Together(
      { photons.At(this->MapOf(&ReplicateSums::back)), adaptive.Back(), factor });
  }
  refined.frontByColour =
    this->Second->Together({ photons.At(this->Sums.FrontByColour(this->Scale())), front, factor });
  for (std::size_t lamp = 0; lamp < this->Sums.layers.lampCells.lamps; ++lamp)
  {
    refined.frontOfLamps.push_back(
      this->Second->Together({ photons.At(this->LampAlone(lamp)), front, factor }, lamp));
  }
  return refined;
}

} // namespace PhotonTransport
