// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/SmoothingGraph.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// An order in which neighbours are near each other in memory, whatever order the mesh has: that of
/// a breadth-first search (Cuthill and McKee, 1969). Memory, not arithmetic, is what smoothing
/// waits for.
class VertexOrder
{
public:
  explicit VertexOrder(const SmoothingGraph& graph);

  /// The vertex of the graph at a place in the order.
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
