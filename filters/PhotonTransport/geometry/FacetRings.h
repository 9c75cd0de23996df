// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/memory/LargeArray.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace PhotonTransport
{

/// Consecutive elements of an array.
template <typename Element>
struct Range
{
  const Element* first;
  const Element* last;
  const Element* begin() const { return this->first; }
  const Element* end() const { return this->last; }
};

/// Stands for a facet's corner that belongs to the ring of no vertex.
constexpr std::uint32_t NoVertex = 0xffffffffu;

/// For each vertex its ring: the facets that share it, as one flat list.
class FacetRings
{
public:
  FacetRings() = default;
  /// @param verticesOf Gives the three vertices of a facet by its index, each one below
  /// `vertexCount` or NoVertex.
  template <typename VerticesOf>
  FacetRings(std::size_t vertexCount, std::size_t facetCount, const VerticesOf& verticesOf);
  FacetRings(std::size_t vertexCount, const std::vector<glm::uvec3>& facets)
    : FacetRings(vertexCount, facets.size(), [&](std::size_t f) { return facets[f]; })
  {
  }

  Range<std::uint32_t> Of(std::uint32_t vertex) const
  {
    const std::uint32_t* base = this->Facets.data();
    return { base + this->Begin(vertex), base + this->Begin(vertex + 1) };
  }
  /// Where its ring begins in the list of all.
  std::size_t Begin(std::uint32_t vertex) const { return this->Offsets[vertex]; }
  /// Of the list of all rings.
  std::size_t Length() const { return this->Facets.size(); }

private:
  std::vector<std::uint64_t> Offsets;
  LargeArray<std::uint32_t> Facets;
};

template <typename VerticesOf>
FacetRings::FacetRings(
  std::size_t vertexCount, std::size_t facetCount, const VerticesOf& verticesOf)
  : Offsets(vertexCount + 2, 0)
{
  const auto forEachCorner = [&](const auto& f)
  {
    for (std::size_t facet = 0; facet < facetCount; ++facet)
    {
      const glm::uvec3 vertices = verticesOf(facet);
      for (int corner = 0; corner < 3; ++corner)
      {
        if (vertices[corner] != NoVertex)
        {
          f(vertices[corner], static_cast<std::uint32_t>(facet));
        }
      }
    }
  };
  // Sizes of rings become their beginnings, and these move to their ends as facets are added.
  forEachCorner([&](std::size_t vertex, std::uint32_t) { ++this->Offsets[vertex + 2]; });
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  ResizeOnHugePages(this->Facets, this->Offsets.back());
  forEachCorner([&](std::size_t vertex, std::uint32_t facet)
    { this->Facets[this->Offsets[vertex + 1]++] = facet; });
  this->Offsets.pop_back();
}

} // namespace PhotonTransport
