// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/VertexOrder.h"

namespace PhotonTransport
{

VertexOrder::VertexOrder(const SmoothingGraph& graph)
  : PlaceOf(graph.Vertices())
{
  constexpr std::uint32_t None = ~0u;
  this->Vertices.reserve(graph.Vertices());
  this->PlaceOf.assign(graph.Vertices(), None);
  const auto append = [&](std::uint32_t vertex)
  {
    if (this->PlaceOf[vertex] == None)
    {
      this->PlaceOf[vertex] = static_cast<std::uint32_t>(this->Vertices.size());
      this->Vertices.push_back(vertex);
    }
  };
  std::size_t next = 0; // place whose neighbours come next
  for (std::uint32_t seed = 0; seed < graph.Vertices(); ++seed)
  {
    append(seed);
    for (; next < this->Vertices.size(); ++next)
    {
      for (const SmoothingGraph::Edge& edge : graph.At(this->Vertices[next]))
      {
        append(edge.neighbour);
      }
    }
  }
}

} // namespace PhotonTransport
