// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/NoiseModel.h"

#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/threads/Threads.h"

#include <cmath>

namespace PhotonTransport
{
namespace
{

/// 1 or -1 for each group, the same in every run.
Group RandomSigns(std::uint32_t vertex)
{
  const std::uint32_t bits = Philox({ vertex, 0, 0, 0 }, { 0x4E6F6973u, 0x65u })[0];
  Group signs;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    signs[g] = (bits >> g & 1u) != 0 ? 1.0f : -1.0f;
  }
  return signs;
}

/// Noise of variance 1 at a vertex. A hit counts for three vertices: on a regular mesh neighbours'
/// noise has a correlation of 1/6, which this share of the neighbours' signs gives.
Group UnitNoise(const SmoothingGraph& graph, std::uint32_t vertex)
{
  constexpr float Share = 0.144f; // an explicit step of diffusion by that time
  float own = 1.0f;
  float squares = 0.0f;
  Group noise{};
  for (const SmoothingGraph::Edge& edge : graph.At(vertex))
  {
    const float weight = Share * edge.conductance * graph.InverseArea(vertex);
    const Group signs = RandomSigns(edge.neighbour);
    for (std::size_t g = 0; g < Groups; ++g)
    {
      noise[g] += weight * signs[g];
    }
    own -= weight;
    squares += weight * weight;
  }
  const Group signs = RandomSigns(vertex);
  const float scale = 1.0f / std::sqrt(squares + own * own);
  for (std::size_t g = 0; g < Groups; ++g)
  {
    noise[g] = scale * (noise[g] + own * signs[g]);
  }
  return noise;
}

} // namespace

GroupColumns GroupsFromStandardError(const SmoothingGraph& graph, const std::vector<double>& values,
  const std::vector<double>& standardError)
{
  GroupColumns groups(values.size());
  ForEach(values.size(),
    [&](std::size_t v)
    {
      const Group noise = UnitNoise(graph, static_cast<std::uint32_t>(v));
      const double mean = MeanOf(noise);
      // The mean of the groups has the standard error, a group sqrt(Groups) times as much.
      const double scale = standardError[v] * std::sqrt(static_cast<double>(Groups));
      for (std::size_t g = 0; g < Groups; ++g)
      {
        groups[v][g] = static_cast<float>(values[v] + scale * (double{ noise[g] } - mean));
      }
    });
  return groups;
}

std::vector<double> StandardErrorFromRoughness(
  const SmoothingGraph& graph, const std::vector<double>& values, const FiltrationMonitor& monitor)
{
  constexpr double Finest = 0.5;
  constexpr double Neighbourhood = 16.0;
  // Column 0: the map; columns 1 to 3: noise of variance 1 / area. What the finest kernel takes
  // away of both, squared, tells how much of the map is noise.
  Columns<4> maps(values.size());
  ForEach(values.size(),
    [&](std::size_t v)
    {
      const Group noise = UnitNoise(graph, static_cast<std::uint32_t>(v));
      const float scale = std::sqrt(graph.InverseArea(v));
      maps[v] = { static_cast<float>(values[v]), scale * noise[1], scale * noise[2],
        scale * noise[3] };
    });
  const Columns<4> smooth =
    Apply<4>(graph, { SpectralFilter::Heat(Finest) }, maps, monitor).front();
  ForEach(values.size(),
    [&](std::size_t v)
    {
      for (std::size_t n = 0; n < 4; ++n)
      {
        const float taken = maps[v][n] - smooth[v][n];
        maps[v][n] = taken * taken;
      }
    });
  const Columns<4> pooled =
    Apply<4>(graph, { SpectralFilter::Heat(Neighbourhood) }, maps, monitor).front();
  std::vector<double> errors(values.size(), 0.0);
  ForEach(values.size(),
    [&](std::size_t v)
    {
      const double unit = (double{ pooled[v][1] } + pooled[v][2] + pooled[v][3]) / 3.0;
      if (unit > 0.0 && pooled[v][0] > 0.0f)
      {
        errors[v] = std::sqrt(double{ pooled[v][0] } / unit * double{ graph.InverseArea(v) });
      }
    });
  return errors;
}

} // namespace PhotonTransport
