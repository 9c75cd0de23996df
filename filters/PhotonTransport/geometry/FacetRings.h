// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
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
  FacetRings(std::size_t vertexCount, const std::vector<glm::uvec3>& facets);

  Range<std::uint32_t> Of(std::uint32_t vertex) const
  {
    const std::uint32_t* base = this->Facets.data();
    return { base + this->Offsets[vertex], base + this->Offsets[vertex + 1] };
  }

private:
  std::vector<std::uint64_t> Offsets;
  std::vector<std::uint32_t> Facets;
};

} // namespace PhotonTransport
