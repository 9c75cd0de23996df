// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/PhotonNoise.h"

namespace PhotonTransport
{

PhotonNoise::PhotonNoise(const SmoothingGraph& graph, double lumens)
  : Photon(graph.Vertices(), 0.0f)
{
  for (std::size_t v = 0; v < this->Photon.size(); ++v)
  {
    const double area = graph.VertexAreas()[v];
    this->Photon[v] = area > 0.0 ? static_cast<float>(lumens / area) : 0.0f;
  }
}

double LumensPerPhoton(const SmoothingGraph& graph, const std::vector<double>& illuminance,
  const std::vector<double>& hits)
{
  double flux = 0.0;
  double shares = 0.0;
  for (std::size_t v = 0; v < hits.size(); ++v)
  {
    flux += graph.VertexAreas()[v] * illuminance[v];
    shares += hits[v];
  }
  return shares > 0.0 ? 3.0 * flux / shares : 0.0;
}

double LumensPerPhoton(const SmoothingGraph& graph, const GroupColumns& map)
{
  double flux = 0.0;
  double variance = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    const double area = graph.VertexAreas()[v];
    flux += area * MeanOf(map[v]);
    variance += area * area * Variance(map[v]);
  }
  return flux > 0.0 ? 2.0 * variance / flux : 0.0;
}

} // namespace PhotonTransport
