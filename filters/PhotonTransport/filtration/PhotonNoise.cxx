// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/PhotonNoise.h"

namespace PhotonTransport
{
namespace
{

/// Where fewer photons are counted a patch tells nothing of its own.
constexpr double Enough = 3.0 * 30.0; // hits
constexpr double Alike = 2.0;

double PerPhoton(double flux, double hits)
{
  return hits > 0.0 ? 3.0 * flux / hits : 0.0;
}

} // namespace

PhotonNoise::PhotonNoise(const SmoothingGraph& graph, const std::vector<double>& lumens)
  : Photon(graph.Vertices(), 0.0f)
{
  for (std::size_t v = 0; v < this->Photon.size(); ++v)
  {
    const double area = graph.VertexAreas()[v];
    this->Photon[v] =
      area > 0.0 ? static_cast<float>(lumens[graph.PatchOfVertex()[v]] / area) : 0.0f;
  }
}

std::vector<double> LumensPerPhoton(const SmoothingGraph& graph,
  const std::vector<double>& illuminance, const std::vector<double>& hits)
{
  double allFlux = 0.0;
  double allHits = 0.0;
  std::vector<double> flux(graph.Patches(), 0.0), shares(graph.Patches(), 0.0);
  for (std::size_t v = 0; v < hits.size(); ++v)
  {
    const std::uint32_t patch = graph.PatchOfVertex()[v];
    flux[patch] += graph.VertexAreas()[v] * illuminance[v];
    shares[patch] += hits[v];
    allFlux += graph.VertexAreas()[v] * illuminance[v];
    allHits += hits[v];
  }
  const double mean = PerPhoton(allFlux, allHits);
  std::vector<double> lumens(graph.Patches(), mean);
  for (std::size_t patch = 0; patch < lumens.size(); ++patch)
  {
    const double own = PerPhoton(flux[patch], shares[patch]);
    if (shares[patch] >= Enough && (own > Alike * mean || Alike * own < mean))
    {
      lumens[patch] = own;
    }
  }
  return lumens;
}

std::vector<double> LumensPerPhoton(const SmoothingGraph& graph, const GroupColumns& map)
{
  double flux = 0.0;
  double variance = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    const double area = graph.VertexAreas()[v];
    flux += area * MeanOf(map[v]);
    variance += area * area * Variance(map[v]);
  }
  return std::vector<double>(graph.Patches(), flux > 0.0 ? 2.0 * variance / flux : 0.0);
}

} // namespace PhotonTransport
