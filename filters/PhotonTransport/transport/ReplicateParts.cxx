// SPDX-License-Identifier: BSD-3-Clause
// The light of replicates by colour and by lamp.
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/statistics/FewHits.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/threads/Threads.h"
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

  void Add(const LightLayers& layers, std::size_t vertex, std::uint64_t hits)
  {
    this->number += static_cast<double>(hits);
    for (std::size_t c = 0; c < LightLayers::Channels; ++c)
    {
      this->weights += layers.Weights(vertex, c);
      this->squares[c] += layers.Weights(vertex, LightLayers::Channels + c);
    }
  }
  double MeanWeight() const
  {
    return this->weights > 0.0 ? this->weights / this->number : FewHits::WithoutCompensation;
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
  ForEach(this->front.Vertices(),
    [&](std::size_t v)
    {
      for (std::size_t c = 0; c < LightLayers::Channels; ++c)
      {
        sums[LightLayers::Channels * v + c] += ofReplicate.sums[v * ofReplicate.perVertex + c];
      }
    });
}

std::vector<ByColour> ReplicateSums::ColourErrors(
  double flux, const std::vector<double>& areas, const std::vector<float>& startWeights) const
{
  std::vector<ByColour> errors(this->colours.empty() ? 0 : areas.size(), ByColour{});
  Hits all;
  for (std::size_t v = 0; v < errors.size(); ++v)
  {
    all.Add(this->layers, v, this->front.hits[v]);
  }
  const std::vector<double> photons = this->PhotonsOfReplicates();
  const auto emitted = static_cast<double>(this->Balance().emitted);
  const FewHits fewHits(all.MeanWeight(), this->CanTellSpread(), startWeights);
  ForEach(errors.size(),
    [&](std::size_t v)
    {
      Hits here;
      here.Add(this->layers, v, this->front.hits[v]);
      const double least = fewHits.StandardError(0.0, this->front.hits[v], here.weights);
      for (std::size_t c = 0; c < LightLayers::Channels; ++c)
      {
        ReplicateStatistics statistics;
        for (std::size_t r = 0; r < photons.size(); ++r)
        {
          const FixedPoint sum = this->colours[r][LightLayers::Channels * v + c];
          statistics.Add(FromFixedPoint(sum) / photons[r], photons[r]);
        }
        constexpr double Further = 2.0; // hits
        const double meanSquare = (here.number * here.MeanSquare(c) + Further * all.MeanSquare(c)) /
          (here.number + Further);
        const double error =
          std::max(emitted * statistics.StandardError(), std::sqrt(meanSquare) * least);
        errors[v][c] = IlluminanceOf(flux, areas[v], error, emitted) /
          double{ LuminousWeights[static_cast<int>(c)] };
      }
    });
  return errors;
}

std::vector<std::array<double, 3>> ReplicateSums::FrontByColour(
  double flux, const std::vector<double>& areas) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  std::vector<std::array<double, 3>> map(this->layers.HasColour() ? areas.size() : 0);
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      map[v][c] = IlluminanceOf(flux, areas[v], this->layers.Weights(v, c), emitted) /
        double{ LuminousWeights[static_cast<int>(c)] };
    }
  }
  return map;
}

std::vector<double> ReplicateSums::FrontOfLamp(
  std::size_t lamp, double flux, const std::vector<double>& areas) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  std::vector<double> map(areas.size(), 0.0);
  for (std::size_t v = 0; v < map.size() && this->layers.HasLamps(); ++v)
  {
    map[v] = IlluminanceOf(
      flux, areas[v], this->layers.Weights(v, this->layers.firstLamp + lamp), emitted);
  }
  return map;
}

} // namespace PhotonTransport
