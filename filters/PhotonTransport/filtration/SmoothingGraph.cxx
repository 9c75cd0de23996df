// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/SmoothingGraph.h"

#include "PhotonTransport/filtration/RingEdges.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace PhotonTransport
{
namespace
{

void RequireFinite(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  for (const glm::uvec3& facet : facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec3& point = points[facet[corner]];
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
      {
        throw InvalidInput(InvalidInput::Where::Point, facet[corner], "it has no finite position");
      }
    }
  }
}

std::vector<Crossing> AllCrossings(const RingEdges& rings, std::size_t vertices)
{
  std::vector<Crossing> crossings(vertices);
  ParallelFor(0, vertices,
    [&](std::size_t first, std::size_t last)
    {
      std::vector<RingEdge> edges;
      for (std::size_t v = first; v < last; ++v)
      {
        rings.At(static_cast<std::uint32_t>(v), edges);
        crossings[v] = rings.CrossingAt(static_cast<std::uint32_t>(v), edges);
      }
    });
  return crossings;
}

/// A vertex on a crease mixes the light of both sides, so only its like along the crease may have
/// any of it.
bool Conducts(const RingEdge& edge, Crossing from, Crossing to)
{
  const Crossing needed = edge.crease ? Crossing::AlongCrease : Crossing::Free;
  return from == needed && to == needed;
}

} // namespace

SmoothingGraph::SmoothingGraph(
  const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets, double creaseAngle)
  : Areas(points.size())
  , InverseAreas(points.size())
  , First(points.size() + 1, 0)
  , AtBorder(points.size(), 0)
{
  RequireFinite(points, facets);
  const RingEdges rings(points, facets, creaseAngle);
  this->FindAreas(rings);
  this->Edges.resize(6 * facets.size());
  this->Connect(rings);
  this->LimitEigenvalues();
  this->FindPatches();
}

SmoothingGraph::SmoothingGraph(const SmoothingGraph& graph, const VertexOrder& order)
  : Areas(order.Ordered(graph.Areas))
  , InverseAreas(order.Ordered(graph.InverseAreas))
  , First(graph.First.size(), 0)
  , Edges(graph.Edges.size())
  , Patch(order.Ordered(graph.Patch))
  , AtBorder(order.Ordered(graph.AtBorder))
  , PatchCount(graph.PatchCount)
{
  for (std::size_t place = 0; place < graph.Vertices(); ++place)
  {
    const Range<Edge> edges = graph.At(order.At(place));
    this->First[place + 1] =
      this->First[place] + static_cast<std::uint64_t>(edges.end() - edges.begin());
  }
  ForEach(graph.Vertices(),
    [&](std::size_t place)
    {
      Edge* next = this->Edges.data() + this->First[place];
      for (const Edge& edge : graph.At(order.At(place)))
      {
        *next++ = { order.Places()[edge.neighbour], edge.conductance };
      }
    });
}

VertexOrder SmoothingGraph::BreadthFirstOrder() const
{
  std::vector<std::uint32_t> vertices;
  vertices.reserve(this->Vertices());
  std::vector<std::uint8_t> seen(this->Vertices(), 0);
  const auto append = [&](std::uint32_t vertex)
  {
    if (seen[vertex] == 0)
    {
      seen[vertex] = 1;
      vertices.push_back(vertex);
    }
  };
  std::size_t next = 0; // place whose neighbours come next
  for (std::uint32_t seed = 0; seed < this->Vertices(); ++seed)
  {
    append(seed);
    for (; next < vertices.size(); ++next)
    {
      for (const Edge& edge : this->At(vertices[next]))
      {
        append(edge.neighbour);
      }
    }
  }
  return VertexOrder(std::move(vertices));
}

void SmoothingGraph::FindAreas(const RingEdges& rings)
{
  ForEach(this->Vertices(),
    [&](std::size_t v) { this->Areas[v] = rings.AreaOf(static_cast<std::uint32_t>(v)); });
  const double mean = std::accumulate(this->Areas.begin(), this->Areas.end(), 0.0) /
    static_cast<double>(std::max<std::size_t>(1, this->Vertices()));
  ForEach(this->Vertices(),
    [&](std::size_t v)
    {
      this->InverseAreas[v] =
        this->Areas[v] > 0.0 ? static_cast<float>(mean / this->Areas[v]) : 0.0f;
    });
}

/// Each vertex writes its edges to a place of its own; then the gaps between them close.
void SmoothingGraph::Connect(const RingEdges& rings)
{
  const std::vector<Crossing> crossings = AllCrossings(rings, this->Vertices());
  ParallelFor(0, this->Vertices(),
    [&](std::size_t first, std::size_t last)
    {
      std::vector<RingEdge> edges;
      for (std::size_t v = first; v < last; ++v)
      {
        rings.At(static_cast<std::uint32_t>(v), edges);
        const auto isBorder = [&](const RingEdge& edge)
        { return edge.rim || !Conducts(edge, crossings[v], crossings[edge.neighbour]); };
        this->AtBorder[v] =
          crossings[v] == Crossing::Free && std::any_of(edges.begin(), edges.end(), isBorder);
        Edge* next = this->Edges.data() + rings.FirstPlace(static_cast<std::uint32_t>(v));
        for (const RingEdge& edge : edges)
        {
          // The harmonic mean of both areas.
          const float sum = this->InverseAreas[v] + this->InverseAreas[edge.neighbour];
          if (sum > 0.0f && Conducts(edge, crossings[v], crossings[edge.neighbour]))
          {
            *next++ = { edge.neighbour, edge.weight * 2.0f / sum };
            ++this->First[v + 1];
          }
        }
      }
    });
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  for (std::size_t v = 0; v < this->Vertices(); ++v)
  {
    std::copy_n(this->Edges.data() + rings.FirstPlace(static_cast<std::uint32_t>(v)),
      this->First[v + 1] - this->First[v], this->Edges.data() + this->First[v]);
  }
  this->Edges.resize(this->First.back());
  this->Edges.shrink_to_fit();
}

/// Gershgorin: no eigenvalue of A^-1 L exceeds twice the largest sum_u c_vu / A_v.
void SmoothingGraph::LimitEigenvalues()
{
  std::vector<float> factor(this->Vertices(), 1.0f);
  ForEach(this->Vertices(),
    [&](std::size_t v)
    {
      float sum = 0.0f;
      for (const Edge& edge : this->At(v))
      {
        sum += edge.conductance;
      }
      const float row = sum * this->InverseAreas[v];
      constexpr float Most = 0.5f * LargestEigenvalue;
      factor[v] = row > Most ? Most / row : 1.0f;
    });
  ForEach(this->Vertices(),
    [&](std::size_t v)
    {
      for (std::uint64_t e = this->First[v]; e < this->First[v + 1]; ++e)
      {
        this->Edges[e].conductance *= std::min(factor[v], factor[this->Edges[e].neighbour]);
      }
    });
}

void SmoothingGraph::FindPatches()
{
  constexpr std::uint32_t Unseen = ~0u;
  this->Patch.assign(this->Vertices(), Unseen);
  std::vector<std::uint32_t> front;
  for (std::size_t seed = 0; seed < this->Vertices(); ++seed)
  {
    if (this->Patch[seed] != Unseen)
    {
      continue;
    }
    const auto patch = static_cast<std::uint32_t>(this->PatchCount++);
    this->Patch[seed] = patch;
    front.assign(1, static_cast<std::uint32_t>(seed));
    while (!front.empty())
    {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const Edge& edge : this->At(v))
      {
        if (this->Patch[edge.neighbour] == Unseen)
        {
          this->Patch[edge.neighbour] = patch;
          front.push_back(edge.neighbour);
        }
      }
    }
  }
}

void SmoothingGraph::CutAround(const std::vector<std::uint8_t>& marked)
{
  ForEach(this->Vertices(),
    [&](std::size_t v)
    {
      for (std::uint64_t e = this->First[v]; e < this->First[v + 1]; ++e)
      {
        Edge& edge = this->Edges[e];
        edge.conductance = marked[v] == marked[edge.neighbour] ? edge.conductance : 0.0f;
      }
    });
}

} // namespace PhotonTransport
