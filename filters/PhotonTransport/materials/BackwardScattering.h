// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/materials/ColourScattering.h"
#include "PhotonTransport/materials/Fresnel.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/sampling/PhotonSample.h"

#include <algorithm>

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

/// What becomes of a ray at a facet: see ScatterColours, with the channels' shares in white light.
/// With the probability of what is absorbed the ray ends.
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
  const auto [departure, weights] =
    ScatterColours<AllScatterings>(material, LuminousWeights, sample, direction, normal, front);
  FollowedRay ray{ !departure.absorbed, departure.how, departure.sameSide, departure.undeflected,
    departure.direction, weights };
  if (departure.how == Scattering::Refraction && !departure.sameSide)
  {
    ray.weight /= ClearBoundary::RadianceDivisor(material, front);
  }
  return ray;
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
