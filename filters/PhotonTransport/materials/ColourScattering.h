// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/materials/Fresnel.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/materials/ScatteringSet.h"
#include "PhotonTransport/sampling/PhotonSample.h"

#include <algorithm>
#include <array>
#include <cstdint>

/// Light of all channels that goes one way. What becomes of it is drawn by a mean of what the
/// channels do, and each channel is weighed by what it does over that mean.

namespace PhotonTransport
{

/// What becomes of light of all channels at a facet.
struct ColourDeparture
{
  Departure departure;
  /// By which the light of each channel is multiplied so that on average over many tries each goes
  /// on as by Scatter; 1 where the material treats all channels alike.
  Colour weights{ 1.0f };
};

/// The mean of what the channels have: that number itself, to the bit, where it is the same for
/// all. @param shares Of the channels in the mean, together 1 up to rounding, which must not give
/// red a negative share.
inline double MeanOfChannels(const std::array<double, 3>& channels, const Colour& shares)
{
  const double green{ shares.y };
  const double blue = std::min(double{ shares.z }, 1.0 - green);
  return channels[0] + green * (channels[1] - channels[0]) + blue * (channels[2] - channels[0]);
}

/// By which the channels' light is multiplied where light takes a way with the probability `mean`
/// that the channels alone take with those of `channels`, all to one scale.
inline Colour ChannelWeights(const std::array<double, 3>& channels, double mean)
{
  const auto weight = [&](unsigned c)
  { return mean > 0.0 ? static_cast<float>(channels[c] / mean) : 0.0f; };
  return { weight(0), weight(1), weight(2) };
}

/// The roulette of light of all channels. Its `internal` has no meaning.
inline RouletteChannel MeanRoulette(
  const std::array<RouletteChannel, 3>& channels, const Colour& shares)
{
  const auto mean = [&](std::uint64_t RouletteChannel::*edge)
  {
    const auto of = [&](unsigned c) { return static_cast<double>(channels[c].*edge); };
    return static_cast<std::uint64_t>(
      std::max(0.0, MeanOfChannels({ of(0), of(1), of(2) }, shares)));
  };
  // Intervals that are empty in all channels must not get a negative length by rounding.
  const std::uint64_t diffuse = mean(&RouletteChannel::diffuse);
  const std::uint64_t specular = std::max(diffuse, mean(&RouletteChannel::specular));
  const std::uint64_t glossy = std::max(specular, mean(&RouletteChannel::glossy));
  return { diffuse, specular, glossy, std::max(glossy, mean(&RouletteChannel::through)), 0.0f };
}

/// Of 2^32, the share of a way of scattering that is not the clear part's.
inline double ShareOf(Scattering how, const RouletteChannel& channel)
{
  switch (how)
  {
    case Scattering::DiffuseReflection:
      return static_cast<double>(channel.diffuse);
    case Scattering::SpecularReflection:
      return static_cast<double>(channel.specular - channel.diffuse);
    case Scattering::GlossyReflection:
      return static_cast<double>(channel.glossy - channel.specular);
    default:
      return static_cast<double>(channel.through - channel.glossy);
  }
}

/// Of 2^32, what a channel leaves to the clear part.
inline double ClearShareOf(const RouletteChannel& channel)
{
  return 0x1p32 - static_cast<double>(channel.through);
}

/// The clear part of a pane or of a body's surface; see ScatterColours. @param u In [0, 1).
inline ColourDeparture PassClearInColours(const Roulette& material, const Colour& shares, float u,
  const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  const ClearBoundary boundary(material, direction, normal, front);
  std::array<double, 3> all{}, reflected{}, transmitted{};
  bool absorbs = false;
  for (unsigned c = 0; c < 3; ++c)
  {
    const RouletteChannel& channel = material.channels[c];
    const ReflectedAndTransmitted share = boundary.Shares(channel.internal);
    all[c] = ClearShareOf(channel);
    reflected[c] = all[c] * double{ share.reflected };
    transmitted[c] = all[c] * double{ share.transmitted };
    absorbs = absorbs || channel.internal < 1.0f;
  }
  const double place = double{ u } * MeanOfChannels(all, shares);
  const double meanReflected = MeanOfChannels(reflected, shares);
  const double meanTransmitted = MeanOfChannels(transmitted, shares);
  ColourDeparture light;
  Departure& departure = light.departure;
  // A sum that rounds below 1 must not absorb where nothing does.
  departure.absorbed = absorbs && !(place < meanReflected + meanTransmitted);
  departure.how = boundary.How();
  departure.sameSide = place < meanReflected;
  departure.undeflected = !departure.sameSide && !material.solid;
  departure.direction = departure.sameSide ? boundary.Mirrored() : boundary.Passed();
  light.weights = departure.sameSide ? ChannelWeights(reflected, meanReflected)
                                     : ChannelWeights(transmitted, meanTransmitted);
  return light;
}

/// ScatterColours for a material that treats the channels unequally. It is not inlined, so that the
/// code that most scenes need stays small.
template <ScatteringSet Possible>
[[gnu::noinline]] ColourDeparture ScatterUnequally(const Roulette& material, const Colour& shares,
  const ScatteringSample& sample, const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  const RouletteChannel mean = MeanRoulette(material.channels, shares);
  if constexpr ((Possible & Transmissions) != 0)
  {
    if (material.clear && sample.survival >= mean.through)
    {
      return PassClearInColours(material, shares, sample.u, direction, normal, front);
    }
  }
  ColourDeparture light{ Scatter<Possible>(material, mean, sample, direction, normal, front) };
  std::array<double, 3> ofChannels{};
  for (unsigned c = 0; c < 3; ++c)
  {
    ofChannels[c] = ShareOf(light.departure.how, material.channels[c]);
  }
  light.weights = ChannelWeights(ofChannels, ShareOf(light.departure.how, mean));
  return light;
}

/// What becomes of light of all channels at a facet: the way in which it goes on, or that it is
/// absorbed, is drawn by the mean of the channels' shares.
/// @tparam Possible What is compiled in. @param shares Of the channels in that mean, together 1.
/// @param direction Unit, of the arriving ray. @param normal Unit, on the side it comes from.
/// @param front Whether that is the front.
template <ScatteringSet Possible>
ColourDeparture ScatterColours(const Roulette& material, const Colour& shares,
  const ScatteringSample& sample, const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  return material.grey
    ? ColourDeparture{ Scatter<Possible>(
        material, material.channels[0], sample, direction, normal, front) }
    : ScatterUnequally<Possible>(material, shares, sample, direction, normal, front);
}

/// The channels' shares in a photon's luminous flux after it has been scattered with these weights.
/// The flux is as it was: a photon of the shares s that takes a way with the probability
/// p = sum_c s_c p_c has the shares s_c p_c / p after it. What rounding has made of their sum is
/// taken out, so that it does not grow with the path.
inline Colour SharesAfter(const Colour& shares, const Colour& weights)
{
  const Colour after = shares * weights;
  const float sum = after.x + after.y + after.z;
  return sum > 0.0f ? after / sum : shares;
}

} // namespace PhotonTransport
