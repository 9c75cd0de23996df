// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// All vertices of a mesh in some order.
class VertexOrder
{
public:
  /// @param vertices [place] The vertex there; each vertex of the mesh once.
  explicit VertexOrder(std::vector<std::uint32_t> vertices)
    : Vertices(std::move(vertices))
    , PlaceOf(this->Vertices.size())
  {
    for (std::size_t place = 0; place < this->Vertices.size(); ++place)
    {
      this->PlaceOf[this->Vertices[place]] = static_cast<std::uint32_t>(place);
    }
  }

  /// The vertex at a place in the order.
  std::uint32_t At(std::size_t place) const { return this->Vertices[place]; }
  /// The place of each vertex.
  const std::vector<std::uint32_t>& Places() const { return this->PlaceOf; }

  /// Values by vertex in this order, and back.
  template <typename Value>
  std::vector<Value> Ordered(const std::vector<Value>& values) const
  {
    std::vector<Value> ordered(values.size());
    for (std::size_t place = 0; place < values.size(); ++place)
    {
      ordered[place] = values[this->Vertices[place]];
    }
    return ordered;
  }
  template <typename Value>
  std::vector<Value> Restored(const std::vector<Value>& ordered) const
  {
    std::vector<Value> values(ordered.size());
    for (std::size_t place = 0; place < ordered.size(); ++place)
    {
      values[this->Vertices[place]] = ordered[place];
    }
    return values;
  }

private:
  std::vector<std::uint32_t> Vertices;
  std::vector<std::uint32_t> PlaceOf;
};

} // namespace PhotonTransport
