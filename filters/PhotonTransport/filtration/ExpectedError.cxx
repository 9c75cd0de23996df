// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/ExpectedError.h"

#include "PhotonTransport/filtration/Parallel.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

constexpr double WidePool = 64.0;
constexpr double NearPool = 4.0;
constexpr std::size_t SmallPatch = 20; ///< Vertices.

enum Term
{
  Error,      ///< Stein's estimate of the squared error.
  NoiseAfter, ///< Variance of the smoothed map.
  NoiseBefore
};

Columns<4> TermsOf(const SmoothedMap& map, const std::vector<double>& units)
{
  Columns<4> terms(units.size(), Columns<4>::value_type{});
  ForEach(units.size(),
    [&](std::size_t v)
    {
      if (!(units[v] > 0.0))
      {
        return;
      }
      const Group& before = map.before[v];
      const Group& after = map.after[v];
      const double noise = Variance(before);
      const double distance = Square(MeanOf(after) - MeanOf(before));
      terms[v][Error] =
        static_cast<float>((distance + 2.0 * Covariance(after, before) - noise) / units[v]);
      terms[v][NoiseAfter] = static_cast<float>(Variance(after) / units[v]);
      terms[v][NoiseBefore] = static_cast<float>(noise / units[v]);
    });
  return terms;
}

std::vector<std::size_t> SizesOfPatches(const SmoothingGraph& graph)
{
  std::vector<std::size_t> sizes(graph.Patches(), 0);
  for (const std::uint32_t patch : graph.PatchOfVertex())
  {
    ++sizes[patch];
  }
  return sizes;
}

} // namespace

std::vector<double> ExpectedSquaredError(
  const SmoothingGraph& graph, const SmoothedMap& map, const FiltrationMonitor& monitor)
{
  std::vector<double> units(map.after.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const double light = std::max(MeanOf(map.after[v]), 0.0);
      units[v] = map.photons.Variance(v, light + map.photons.OnePhoton(v));
    });
  const std::vector<Columns<4>> pooled = Apply<4>(graph,
    { SpectralFilter::Heat(WidePool), SpectralFilter::Heat(NearPool) }, TermsOf(map, units),
    monitor);
  const std::vector<std::size_t> sizes = SizesOfPatches(graph);
  std::vector<double> errors(units.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const auto& wide = pooled[0][v];
      const auto& near = pooled[1][v];
      float error = std::max({ wide[Error], wide[NoiseAfter], near[Error], 0.0f });
      const std::size_t size = sizes[graph.PatchOfVertex()[v]];
      if (size < SmallPatch && wide[NoiseBefore] > 0.0f)
      {
        error = std::max(error, std::clamp(wide[NoiseAfter] / wide[NoiseBefore], 1.0f / float(size), 1.0f));
      }
      errors[v] = double{ error } * units[v];
      if (!map.dark.empty() && map.dark[v] != 0)
      {
        errors[v] = std::max(errors[v], Square(map.photons.OnePhoton(v) / 3.0));
      }
    });
  return errors;
}

} // namespace PhotonTransport
