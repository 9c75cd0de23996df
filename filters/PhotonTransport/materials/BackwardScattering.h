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

/// Rays that are followed against the light, from where it is received. All ways of scattering are
/// reciprocal, so a ray goes on in the directions in which Scatter sends photons.

namespace PhotonTransport
{

/// What becomes of a ray that is followed against the light, at a facet.
struct FollowedRay
{
  bool goesOn = false;
  Scattering how = Scattering::DiffuseReflection;
  bool sameSide = true;     ///< False: it has gone through.
  bool undeflected = false; ///< Straight through a pane.
  glm::vec3 direction{ 0.0f };
  /// The radiance that comes against `direction`, times the weight, is on average over many rays
  /// what the facet sends back along the ray; rays that end count 0. Where a material treats all
  /// channels alike the weight is 1, otherwise at most 1 / LuminousWeights. Where a body bends the
  /// ray this is divided by the square of the index.
  Colour weight{ 1.0f };
};

/// The luminous mean of what the channels have: that number itself, to the bit, where it is the
/// same for all.
inline double MeanOfChannels(const std::array<double, 3>& channels)
{
  return channels[0] + double{ LuminousWeights.y } * (channels[1] - channels[0]) +
    double{ LuminousWeights.z } * (channels[2] - channels[0]);
}

/// By which the channels' radiances are multiplied where rays take a way with the probability
/// `mean` that photons take with those of `channels`, all to one scale.
inline Colour ChannelWeights(const std::array<double, 3>& channels, double mean)
{
  const auto weight = [&](unsigned c)
  { return mean > 0.0 ? static_cast<float>(channels[c] / mean) : 0.0f; };
  return { weight(0), weight(1), weight(2) };
}

/// The roulette of rays, which carry all channels. Its `internal` has no meaning.
inline RouletteChannel RouletteOfRays(const std::array<RouletteChannel, 3>& channels)
{
  const auto mean = [&](std::uint64_t RouletteChannel::*edge)
  {
    const auto of = [&](unsigned c) { return static_cast<double>(channels[c].*edge); };
    return static_cast<std::uint64_t>(MeanOfChannels({ of(0), of(1), of(2) }));
  };
  return { mean(&RouletteChannel::diffuse), mean(&RouletteChannel::specular),
    mean(&RouletteChannel::glossy), mean(&RouletteChannel::through), 0.0f };
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

/// The clear part of a pane or of a body's surface; see FollowBack. @param u In [0, 1).
inline FollowedRay FollowClear(const Roulette& material, float u, const glm::vec3& direction,
  const glm::vec3& normal, bool front)
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
  const double place = double{ u } * MeanOfChannels(all);
  const double meanReflected = MeanOfChannels(reflected);
  const double meanTransmitted = MeanOfChannels(transmitted);
  FollowedRay ray;
  // A sum that rounds below 1 must not absorb where nothing does.
  ray.goesOn = !absorbs || place < meanReflected + meanTransmitted;
  ray.how = boundary.How();
  ray.sameSide = place < meanReflected;
  ray.undeflected = !ray.sameSide && !material.solid;
  ray.direction = ray.sameSide ? boundary.Mirrored() : boundary.Passed();
  ray.weight = ray.sameSide
    ? ChannelWeights(reflected, meanReflected)
    : ChannelWeights(transmitted, meanTransmitted) / boundary.RadianceDivisor();
  return ray;
}

/// What becomes of a ray at a facet. The way in which it goes on is drawn by the luminous mean of
/// the channels' shares; with the probability of what is absorbed the ray ends.
///
/// Radiance over the square of the refractive index stays the same along a ray, but for what is
/// reflected and absorbed. So the weight of a ray that enters a body of index n against the light
/// is divided by n^2, since light that leaves the body spreads over more directions, and that of a
/// ray that leaves the body is multiplied by n^2.
/// @param direction Unit, in which the ray is followed: away from the receiver. @param normal Unit,
/// on the side that it comes from. @param front Whether that is the front.
inline FollowedRay FollowBack(const Roulette& material, const ScatteringSample& sample,
  const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  Roulette ofRays = material;
  const RouletteChannel& mean = ofRays.channels[0] = RouletteOfRays(material.channels);
  if (sample.survival >= mean.through)
  {
    return material.clear ? FollowClear(material, sample.u, direction, normal, front)
                          : FollowedRay{};
  }
  const Departure departure = Scatter<AllScatterings>(ofRays, 0, sample, direction, normal, front);
  std::array<double, 3> shares{};
  for (unsigned c = 0; c < 3; ++c)
  {
    shares[c] = ShareOf(departure.how, material.channels[c]);
  }
  return { !departure.absorbed, departure.how, departure.sameSide, departure.undeflected,
    departure.direction, ChannelWeights(shares, ShareOf(departure.how, mean)) };
}

/// Whether a material does nothing but reflect and let through diffusely.
inline bool ScattersOnlyDiffusely(const Roulette& material)
{
  return !material.clear &&
    std::all_of(material.channels.begin(), material.channels.end(),
      [](const RouletteChannel& channel) { return channel.glossy == channel.diffuse; });
}

/// Whether light goes straight through a facet.
inline bool IsPane(const Roulette& material)
{
  return material.clear && !material.solid;
}

/// The share of each channel's light that goes straight through a thin clear pane; 0 for the
/// surface of a body, which bends light. @param cosine Of the ray to the normal, (0, 1].
inline Colour PaneTransmittance(const Roulette& material, float cosine)
{
  Colour transmitted(0.0f);
  if (IsPane(material))
  {
    const FresnelReflectances fresnel(std::min(cosine, 1.0f), material.refractiveIndex);
    for (int c = 0; c < 3; ++c)
    {
      const RouletteChannel& channel = material.channels[static_cast<unsigned>(c)];
      transmitted[c] = static_cast<float>(ClearShareOf(channel) * 0x1p-32) *
        ThinPane(fresnel, channel.internal).transmitted;
    }
  }
  return transmitted;
}

} // namespace PhotonTransport
