// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/FacetRings.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What registration makes of light: the mean around each vertex, weighted by the hat function that
/// is 1 at the vertex and falls to 0 over the facets around it. For light that is linear in each
/// facet this is the mass matrix of linear finite elements, each row divided by its sum.
class HatMeans
{
public:
  /// @param scene Must outlive this.
  explicit HatMeans(const Scene& scene);

  std::size_t Vertices() const { return this->RingAreas.size(); }

  /// The hat mean at a vertex of valueOf(vertex) at all vertices, a number or a vector of some. A
  /// vertex without a facet keeps its value.
  template <typename Function>
  auto At(std::size_t vertex, const Function& valueOf) const
  {
    const auto own = valueOf(vertex);
    auto sum = 0.0 * own; // of facets' areas times the sums over their corners
    for (const std::uint32_t facet : this->Rings().Of(static_cast<std::uint32_t>(vertex)))
    {
      const glm::uvec3& ids = this->VerticesOf(facet);
      sum += this->AreaOf(facet) * (valueOf(ids.x) + valueOf(ids.y) + valueOf(ids.z));
    }
    // The integral of two hat functions is A/12 over a common facet, and that of a square A/6.
    const double area = this->RingAreas[vertex];
    return area > 0.0 ? 0.25 * (own + sum / area) : own;
  }

  /// The hat means of values at all vertices.
  std::vector<double> Of(const std::vector<double>& values) const;

  /// Calls f(neighbour, weight) for each facet's two other vertices; each neighbour comes once a
  /// facet. The weights are the neighbours' parts in the vertex's hat mean; their sum is 1/2.
  template <typename Function>
  void ForEachNeighbour(std::uint32_t vertex, const Function& f) const
  {
    if (!(this->RingAreas[vertex] > 0.0))
    {
      return;
    }
    for (const std::uint32_t facet : this->Rings().Of(vertex))
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const std::uint32_t neighbour = this->VerticesOf(facet)[corner];
        if (neighbour != vertex)
        {
          f(neighbour, 0.25 * this->AreaOf(facet) / this->RingAreas[vertex]);
        }
      }
    }
  }

private:
  // The scene's own where it has what is needed, which saves 72 bytes a vertex.
  const FacetRings& Rings() const { return this->OfScene ? *this->OfScene : this->OwnRings; }
  const glm::uvec3& VerticesOf(std::uint32_t facet) const
  {
    return this->OfScene ? this->LitScene.GivenVertices(facet) : this->Facets[facet];
  }
  /// In the scene's unit.
  double AreaOf(std::uint32_t facet) const
  {
    return this->OfScene ? glm::length(glm::dvec3(this->LitScene.AreaVectors()[facet]))
                         : this->FacetAreas[facet];
  }
  std::size_t NumberOfFacets() const
  {
    return this->OfScene ? this->LitScene.Facets().size() : this->Facets.size();
  }
  void AddFacets();

  const Scene& LitScene;
  const FacetRings* OfScene;      ///< Null where facets have parts or copies.
  std::vector<glm::uvec3> Facets; ///< As given, without parts; empty where OfScene serves.
  std::vector<double> FacetAreas; ///< Theirs.
  std::vector<double> RingAreas;  ///< [vertex] Of the facets around.
  FacetRings OwnRings;
};

} // namespace PhotonTransport
