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
  if (!this->OfScene)
  {
    this->AddFacets();
  }
  for (std::uint32_t f = 0; f < this->NumberOfFacets(); ++f)
  {
    const double area = this->AreaOf(f);
    for (int corner = 0; corner < 3; ++corner)
    {
      this->RingAreas[this->VerticesOf(f)[corner]] += area;
    }
  }
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
    [&](std::size_t v) { means[v] = this->At(v, [&](std::size_t u) { return values[u]; }); });
  return means;
}

} // namespace PhotonTransport
