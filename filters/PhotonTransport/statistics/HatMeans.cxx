// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/HatMeans.h"

#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

namespace PhotonTransport
{

HatMeans::HatMeans(const Scene& scene)
  : LitScene(scene)
  , OfScene(scene.WholeRings())
  , RingAreas(scene.NumberOfMapVertices(), 0.0)
{
  this->OfScene ? this->AddWholeFacets() : this->AddFacets();
  for (std::uint32_t f = 0; f < this->FacetAreas.size(); ++f)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->RingAreas[this->VerticesOf(f)[corner]] += this->FacetAreas[f];
    }
  }
}

void HatMeans::AddWholeFacets()
{
  const std::vector<glm::vec3>& areas = this->LitScene.AreaVectors();
  this->FacetAreas.resize(areas.size());
  ForEach(
    areas.size(), [&](std::size_t f) { this->FacetAreas[f] = glm::length(glm::dvec3(areas[f])); });
}

void HatMeans::AddFacets()
{
  this->Facets.reserve(this->LitScene.NumberOfGivenFacets());
  this->FacetAreas.reserve(this->Facets.capacity());
  for (std::uint32_t f = 0; f < this->LitScene.Facets().size(); ++f)
  {
    const glm::uvec3& vertices = this->LitScene.GivenVertices(f);
    if (this->Facets.empty() || this->Facets.back() != vertices)
    {
      this->Facets.push_back(vertices);
      this->FacetAreas.push_back(0.0);
    }
    this->FacetAreas.back() += glm::length(glm::dvec3(this->LitScene.AreaVectors()[f]));
  }
  this->OwnRings = FacetRings(this->Vertices(), this->Facets);
}

std::vector<double> HatMeans::Of(const std::vector<double>& values) const
{
  std::vector<double> means(values.size());
  ForEach(values.size(),
    [&](std::size_t v)
    {
      double sum = 0.0; // of facets' areas times the sums over their corners
      for (const std::uint32_t facet : this->Rings().Of(static_cast<std::uint32_t>(v)))
      {
        const glm::uvec3& ids = this->VerticesOf(facet);
        sum += this->FacetAreas[facet] * (values[ids.x] + values[ids.y] + values[ids.z]);
      }
      // The integral of two hat functions is A/12 over a common facet, and that of a square A/6.
      means[v] =
        this->RingAreas[v] > 0.0 ? 0.25 * (values[v] + sum / this->RingAreas[v]) : values[v];
    });
  return means;
}

} // namespace PhotonTransport
