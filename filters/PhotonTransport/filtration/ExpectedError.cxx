// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/ExpectedError.h"

#include "PhotonTransport/filtration/EdgeBias.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// Errors are means over a wide neighbourhood, and a near one for what stands out.
constexpr double WidePool = 64.0;
constexpr double NearPool = 1.0;
/// Stein's estimate compares with the noisy map; its means have more noise than a smooth map has
/// error. Compared with the map smoothed by this narrow kernel, a map shows less noise, though less
/// of its bias, since the kernel has some itself. The lesser of both estimates counts.
constexpr double NarrowKernel = 1.0;
/// Four groups have three degrees of freedom a vertex, too few in a patch of fewer vertices.
constexpr std::size_t SmallPatch = 20;

enum Term
{
  Error,       ///< Stein's estimate of the squared error: |F - X|^2 + 2 cov(F, X) - var X.
  NarrowError, ///< The same against the narrow kernel's N: |F - N|^2 - var(F - N) + var F.
  NoiseAfter,  ///< var F.
  NoiseBefore  ///< var X.
};
using Terms = Columns<4>;

/// What errors are measured in, lx^2: the photon noise of the smoothed light and one photon more,
/// so that errors of dim and bright vertices can share a mean.
std::vector<double> Units(const SmoothedMap& map)
{
  std::vector<double> units(map.before.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const double light = std::max(MeanOf(map.after.groups[v]), 0.0);
      units[v] = map.photons.Variance(v, light + map.photons.OnePhoton(v));
    });
  return units;
}

/// @param edgeBias Known apart, so that the means tell of the rest.
Terms TermsOf(const SmoothedMap& map, const GroupColumns& narrow,
  const std::vector<double>& edgeBias, const std::vector<double>& units)
{
  Terms terms(units.size(), Terms::value_type{});
  ForEach(units.size(),
    [&](std::size_t v)
    {
      if (!(units[v] > 0.0))
      {
        return; // no area, or no light at all
      }
      const auto inUnits = [&](double square) { return static_cast<float>(square / units[v]); };
      const Group& before = map.before[v];
      const Group& after = map.after.groups[v];
      const Group change = Difference(after, before);
      const Group toNarrow = Difference(after, narrow[v]);
      const double noise = Variance(after);
      // 2 cov(F, X) - var X = var F - var(F - X)
      terms[v][Error] = inUnits(Square(MeanOf(change)) - Variance(change) + noise - edgeBias[v]);
      terms[v][NarrowError] =
        inUnits(Square(MeanOf(toNarrow)) - Variance(toNarrow) + noise - edgeBias[v]);
      terms[v][NoiseAfter] = inUnits(noise);
      terms[v][NoiseBefore] = inUnits(Variance(before));
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

/// In units: no less than the noise that is left.
double ErrorOf(const Terms::value_type& mean)
{
  return double{ std::max({ std::min(mean[Error], mean[NarrowError]), mean[NoiseAfter], 0.0f }) };
}

/// In units, the least error in a small patch, whose groups know little: photon noise by Poisson's
/// law, less the share that smoothing has taken away, down to that of a mean over the patch.
double LeastErrorOf(const Terms::value_type& wide, std::size_t patchSize)
{
  const double least = 1.0 / static_cast<double>(patchSize);
  return wide[NoiseBefore] > 0.0f
    ? std::clamp(double{ wide[NoiseAfter] } / double{ wide[NoiseBefore] }, least, 1.0)
    : least;
}

double MeanLight(const SmoothingGraph& graph, const GroupColumns& map)
{
  double flux = 0.0;
  double area = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    flux += graph.VertexAreas()[v] * MeanOf(map[v]);
    area += graph.VertexAreas()[v];
  }
  return area > 0.0 ? std::max(flux / area, 0.0) : 0.0;
}

} // namespace

std::vector<double> ExpectedSquaredError(
  const SmoothingGraph& graph, const SmoothedMap& map, const FiltrationMonitor& monitor)
{
  const std::vector<double> units = Units(map);
  const std::vector<double> edgeBias = SquaredEdgeBias(graph, map.before, map.after, units);
  const GroupColumns narrow = std::move(
    Apply<Groups>(graph, { SpectralFilter::TwicedHeat(NarrowKernel) }, map.before, monitor)
      .front());
  const std::vector<Terms> pooled =
    Apply<4>(graph, { SpectralFilter::Heat(WidePool), SpectralFilter::Heat(NearPool) },
      TermsOf(map, narrow, edgeBias, units), monitor);
  const std::vector<std::size_t> sizes = SizesOfPatches(graph);
  const double meanLight = MeanLight(graph, map.before);
  std::vector<double> errors(units.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const Terms::value_type& wide = pooled[0][v];
      errors[v] = std::max(ErrorOf(wide), ErrorOf(pooled[1][v])) * units[v] + edgeBias[v];
      const std::size_t size = sizes[graph.PatchOfVertex()[v]];
      if (size < SmallPatch)
      {
        // A small vertex that no photon came to has less light than a photon would bring.
        const double least = LeastErrorOf(wide, size) * units[v];
        errors[v] = std::max(
          errors[v], wide[NoiseBefore] > 0.0f ? least : std::min(least, Square(meanLight)));
      }
      if (!map.dark.empty() && map.dark[v] != 0)
      {
        // The rim of a region without a photon may have a little light in truth.
        errors[v] = std::max(errors[v], Square(map.photons.OnePhoton(v) / 3.0));
      }
    });
  return errors;
}

} // namespace PhotonTransport
