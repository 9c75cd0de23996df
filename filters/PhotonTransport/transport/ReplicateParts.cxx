// SPDX-License-Identifier: BSD-3-Clause
// The light of replicates by colour.
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/LampSum.h"
#include "PhotonTransport/transport/ReplicateSums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace PhotonTransport
{
namespace
{

using ByColour = std::array<double, LightLayers::Channels>;

/// What the hits of a vertex, or of all, have brought.
struct Hits
{
  double number = 0.0;
  double weights = 0.0;
  ByColour squares{}; ///< Weights times the squared shares of the channels.

  void Add(const LightLayers& layers, const LampSum& sumOf, std::size_t vertex, std::uint64_t hits)
  {
    this->number += static_cast<double>(hits);
    for (std::size_t c = 0; c < LightLayers::Channels; ++c)
    {
      this->weights += sumOf(layers.sums, vertex, c, layers.perSlot);
      this->squares[c] += sumOf(layers.sums, vertex, LightLayers::Channels + c, layers.perSlot);
    }
  }
  /// 1 without a hit.
  double MeanSquare(std::size_t channel) const
  {
    return this->weights > 0.0 ? this->squares[channel] / this->weights : 1.0;
  }
};

} // namespace

void ReplicateSums::AddColours(std::size_t replicate, const LightLayers& ofReplicate)
{
  if (this->colours.empty())
  {
    return;
  }
  std::vector<FixedPoint>& sums = this->colours[replicate];
  ForEach(this->front.Slots(),
    [&](std::size_t slot)
    {
      for (std::size_t c = 0; c < LightLayers::Channels; ++c)
      {
        sums[LightLayers::Channels * slot + c] += ofReplicate.sums[slot * ofReplicate.perSlot + c];
      }
    });
}

std::vector<ByColour> ReplicateSums::ColourErrors(
  const MapScale& scale, const LampFactors& factors) const
{
  const std::vector<double>& areas = scale.areas;
  std::vector<ByColour> errors(this->colours.empty() ? 0 : areas.size(), ByColour{});
  if (errors.empty())
  {
    return errors;
  }
  const LampSum sumOf(this->front, factors);
  Hits all;
  IlluminationMap few = IlluminationMap::WithoutLight(areas.size());
  for (std::size_t v = 0; v < errors.size(); ++v)
  {
    sumOf.AddTotals(v, few);
    all.Add(this->layers, sumOf, v, few.photonHits[v]);
  }
  this->CountFewHits(this->front, scale, factors, few); // without a spread
  const std::vector<double> photons = this->PhotonsOfReplicates();
  const auto emitted = static_cast<double>(this->Balance().emitted);
  ForEach(errors.size(),
    [&](std::size_t v)
    {
      Hits here;
      here.Add(this->layers, sumOf, v, few.photonHits[v]);
      const double least = few.standardError[v];
      for (std::size_t c = 0; c < LightLayers::Channels; ++c)
      {
        ReplicateStatistics statistics;
        for (std::size_t r = 0; r < photons.size(); ++r)
        {
          const double sum = sumOf(this->colours[r], v, c, LightLayers::Channels);
          statistics.Add(sum / photons[r], photons[r]);
        }
        constexpr double Further = 2.0; // hits
        const double meanSquare = (here.number * here.MeanSquare(c) + Further * all.MeanSquare(c)) /
          (here.number + Further);
        const double error =
          std::max(emitted * statistics.StandardError(), std::sqrt(meanSquare) * least);
        errors[v][c] = IlluminanceOf(scale.flux, areas[v], error, emitted) /
          double{ LuminousWeights[static_cast<int>(c)] };
      }
    });
  return errors;
}

std::vector<std::array<double, 3>> ReplicateSums::FrontByColour(
  const MapScale& scale, const LampFactors& factors) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  const LampSum sumOf(this->front, factors);
  std::vector<std::array<double, 3>> map(this->layers.HasColour() ? scale.areas.size() : 0);
  ForEach(map.size(),
    [&](std::size_t v)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double weights = sumOf(this->layers.sums, v, c, this->layers.perSlot);
        map[v][c] = IlluminanceOf(scale.flux, scale.areas[v], weights, emitted) /
          double{ LuminousWeights[static_cast<int>(c)] };
      }
    });
  return map;
}

} // namespace PhotonTransport
