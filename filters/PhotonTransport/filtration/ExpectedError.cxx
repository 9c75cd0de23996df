// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/ExpectedError.h"

#include "PhotonTransport/filtration/Parallel.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// Errors are means over a wide neighbourhood, and a near one for what stands out beside edges.
constexpr double WidePool = 64.0;
constexpr double NearPool = 1.0;
/// The near mean of Stein's estimate has more noise than a smooth map has error. Compared with the
/// map smoothed by this narrow kernel, the smoothed map shows less noise, and less of its bias,
/// since the kernel has some itself: this many times as much bounds the estimate.
constexpr double NarrowKernel = 1.0;
constexpr float NarrowBound = 2.0f;
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
  std::vector<double> units(map.after.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const double light = std::max(MeanOf(map.after[v]), 0.0);
      units[v] = map.photons.Variance(v, light + map.photons.OnePhoton(v));
    });
  return units;
}

Terms TermsOf(const SmoothedMap& map, const GroupColumns& narrow, const std::vector<double>& units)
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
      const Group& after = map.after[v];
      const Group change = Difference(after, before);
      const Group toNarrow = Difference(after, narrow[v]);
      const double noise = Variance(after);
      // 2 cov(F, X) - var X = var F - var(F - X)
      terms[v][Error] = inUnits(Square(MeanOf(change)) - Variance(change) + noise);
      terms[v][NarrowError] = inUnits(Square(MeanOf(toNarrow)) - Variance(toNarrow) + noise);
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

/// In units: no less than the noise that is left, by Poisson's law where the groups know little.
float ErrorAt(const Terms::value_type& wide, const Terms::value_type& near, std::size_t patchSize)
{
  const float nearError = std::min(near[Error], NarrowBound * near[NarrowError]);
  const float error = std::max({ wide[Error], wide[NoiseAfter], nearError, 0.0f });
  if (patchSize >= SmallPatch || !(wide[NoiseBefore] > 0.0f))
  {
    return error;
  }
  const float least = 1.0f / static_cast<float>(patchSize); // a mean over the patch
  return std::max(error, std::clamp(wide[NoiseAfter] / wide[NoiseBefore], least, 1.0f));
}

} // namespace

std::vector<double> ExpectedSquaredError(
  const SmoothingGraph& graph, const SmoothedMap& map, const FiltrationMonitor& monitor)
{
  const std::vector<double> units = Units(map);
  const GroupColumns narrow = std::move(
    Apply<Groups>(graph, { SpectralFilter::TwicedHeat(NarrowKernel) }, map.before, monitor)
      .front());
  const std::vector<Terms> pooled =
    Apply<4>(graph, { SpectralFilter::Heat(WidePool), SpectralFilter::Heat(NearPool) },
      TermsOf(map, narrow, units), monitor);
  const std::vector<std::size_t> sizes = SizesOfPatches(graph);
  std::vector<double> errors(units.size());
  ForEach(units.size(),
    [&](std::size_t v)
    {
      const std::size_t size = sizes[graph.PatchOfVertex()[v]];
      errors[v] = double{ ErrorAt(pooled[0][v], pooled[1][v], size) } * units[v];
      if (!map.dark.empty() && map.dark[v] != 0)
      {
        // The rim of a region without a photon may have a little light in truth.
        errors[v] = std::max(errors[v], Square(map.photons.OnePhoton(v) / 3.0));
      }
    });
  return errors;
}

} // namespace PhotonTransport
