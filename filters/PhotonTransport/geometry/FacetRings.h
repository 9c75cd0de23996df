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

/// For each vertex its ring: the facets that share it, as one flat list.
class FacetRings
{
public:
  FacetRings() = default;
  FacetRings(std::size_t vertexCount, const std::vector<glm::uvec3>& facets);

  /// The facets of all rings, one ring after the other.
  const std::vector<std::uint32_t>& Facets() const { return this->Flat; }

  /// The part of an array parallel to Facets() that belongs to a vertex.
  template <typename Element>
  Range<Element> Of(std::uint32_t vertex, const std::vector<Element>& parallel) const
  {
    return { parallel.data() + this->Offsets[vertex], parallel.data() + this->Offsets[vertex + 1] };
  }
  Range<std::uint32_t> Of(std::uint32_t vertex) const { return this->Of(vertex, this->Flat); }

private:
  std::vector<std::uint64_t> Offsets;
  std::vector<std::uint32_t> Flat;
};

} // namespace PhotonTransport
