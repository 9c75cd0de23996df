// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/DarkRegions.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Vertices without a photon that hang together, and what surrounds them.
struct Region
{
  std::vector<std::uint32_t> vertices;
  double area = 0.0;        ///< Of the vertices.
  double largestArea = 0.0; ///< Of one vertex.
  double litHits = 0.0;     ///< On the lit vertices around it; one counts for each of its edges.
  double litArea = 0.0;
};

Region Grow(const SmoothingGraph& graph, const std::vector<double>& hits, std::uint32_t seed,
  std::vector<std::uint8_t>& seen)
{
  Region region;
  region.vertices.push_back(seed);
  seen[seed] = 1;
  for (std::size_t next = 0; next < region.vertices.size(); ++next)
  {
    const std::uint32_t v = region.vertices[next];
    region.area += graph.VertexAreas()[v];
    region.largestArea = std::max(region.largestArea, graph.VertexAreas()[v]);
    for (const SmoothingGraph::Edge& edge : graph.At(v))
    {
      const std::uint32_t u = edge.neighbour;
      if (hits[u] > 0.0)
      {
        region.litHits += hits[u];
        region.litArea += graph.VertexAreas()[u];
      }
      else if (!seen[u])
      {
        seen[u] = 1;
        region.vertices.push_back(u);
      }
    }
  }
  return region;
}

bool IsCertainlyDark(const Region& region, std::size_t vertices)
{
  if (!(region.litArea > 0.0))
  {
    return false; // nothing to tell how bright it would be
  }
  // A ring's facets cover three times the vertex's area; those of a region at least this much.
  const double facetArea = region.area + 2.0 * region.largestArea;
  const double expected = facetArea * region.litHits / (3.0 * region.litArea);
  // Connected sets of n vertices: about 5.18^n at each vertex of a triangular lattice (site
  // animals). By chance one of them all is dark in fewer than one map in a hundred.
  constexpr double LogAnimalGrowth = 1.645;
  constexpr double Chance = 0.01;
  return expected > std::log(static_cast<double>(vertices) / Chance) +
    LogAnimalGrowth * static_cast<double>(region.vertices.size());
}

} // namespace

std::vector<std::uint8_t> FindDarkRegions(
  const SmoothingGraph& graph, const std::vector<double>& hits)
{
  std::vector<std::uint8_t> dark(graph.Vertices(), 0);
  std::vector<std::uint8_t> seen(graph.Vertices(), 0);
  bool any = false;
  for (std::uint32_t v = 0; v < graph.Vertices(); ++v)
  {
    if (hits[v] > 0.0 || seen[v])
    {
      continue;
    }
    const Region region = Grow(graph, hits, v, seen);
    if (IsCertainlyDark(region, graph.Vertices()))
    {
      any = true;
      for (const std::uint32_t member : region.vertices)
      {
        dark[member] = 1;
      }
    }
  }
  return any ? dark : std::vector<std::uint8_t>();
}

} // namespace PhotonTransport
