// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/materials/Fresnel.h"
#include "PhotonTransport/materials/GlossyReflection.h"
#include "PhotonTransport/materials/Material.h"
#include "PhotonTransport/materials/ScatteringSet.h"
#include "PhotonTransport/sampling/PhotonSample.h"

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// What a photon does next, unless it is absorbed.
struct Departure
{
  bool absorbed = true;
  Scattering how = Scattering::DiffuseReflection;
  bool sameSide = true;     ///< False: it has gone through.
  bool undeflected = false; ///< Straight through a pane.
  glm::vec3 direction{ 0.0f };
};

/// One channel of a material for Russian roulette: the intervals of [0, 2^32) that belong to its
/// shares follow one another, and each begins where the one before ends.
struct RouletteChannel
{
  std::uint64_t diffuse, specular, glossy, through; ///< Upper ends of the intervals.
  float internal; ///< Transmittance of the body of the clear part, which takes the rest.
};

/// A material made ready for photons.
struct Roulette
{
  std::array<RouletteChannel, 3> channels; ///< All the same where photons have no colour.
  float alpha;
  float refractiveIndex;
  bool clear;
  bool solid;
  bool translucent; ///< Lets light through, in any way.
};

/// @param colour Whether photons carry a channel each; otherwise all three are the luminous one.
Roulette MakeRoulette(const Material& material, bool colour);

/// What a material can do with light.
ScatteringSet ScatteringsOf(const Material& material);

/// Whether a material treats the channels unequally.
bool IsColoured(const Material& material);

/// The clear part of a pane or of a body's surface.
inline Departure PassClear(const Roulette& material, float internal, float u,
  const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  Departure departure;
  const float cosIn = std::min(1.0f, -glm::dot(direction, normal));
  if (!material.solid)
  {
    const ReflectedAndTransmitted share = ThinPane(cosIn, material.refractiveIndex, internal);
    // A sum that rounds below 1 must not absorb where nothing does.
    departure.absorbed = internal < 1.0f && !(u < share.reflected + share.transmitted);
    departure.how = Scattering::ClearTransmission;
    departure.sameSide = u < share.reflected;
    departure.undeflected = !departure.sameSide;
    departure.direction =
      departure.sameSide ? glm::normalize(direction + 2.0f * cosIn * normal) : direction;
    return departure;
  }
  const float index = front ? material.refractiveIndex : 1.0f / material.refractiveIndex;
  const FresnelReflectances fresnel(cosIn, index);
  const float reflected = fresnel.Mean();
  departure.how = Scattering::Refraction;
  departure.sameSide = u < reflected;
  departure.absorbed = internal < 1.0f && !(u < reflected + (1.0f - reflected) * internal);
  departure.direction = departure.sameSide
    ? glm::normalize(direction + 2.0f * cosIn * normal)
    : Refract(direction, normal, cosIn, index, std::max(fresnel.cosine, 1e-6f));
  return departure;
}

/// The direction in which the glossy share of the light leaves; none of it is lost. @param place A
/// uniform number in [0, 1).
inline glm::vec3 ReflectFromMicrofacets(const glm::vec3& towards, const glm::vec3& normal,
  float alpha, const ScatteringSample& sample, double place)
{
  const GlossyDirection lobe = ReflectGlossily(towards, normal, alpha, sample.u, sample.v);
  if (place < double{ lobe.probability })
  {
    return lobe.direction;
  }
  // Light that microfacets pass on to each other leaves in all directions, so that nothing is lost.
  // Lambert's law stands in for the nearly equal lobe of Kulla and Conty, "Revisiting Physically
  // Based Shading at Imageworks", 2017. The numbers are fresh, since u and v are not uniform among
  // the photons that get here.
  constexpr std::uint32_t GlossyStream = 0x476c6f73u;
  const std::array<std::uint32_t, 4> fresh =
    Philox({ sample.survival, static_cast<std::uint32_t>(sample.u * 0x1p24f),
             static_cast<std::uint32_t>(sample.v * 0x1p24f), 0 },
      { GlossyStream, 0 });
  return ReflectDiffusely(normal, UnitFloat(fresh[0]), UnitFloat(fresh[1]));
}

/// What becomes of a photon of unit energy: it goes on with all of it, or is absorbed.
/// @tparam Possible What is compiled in. @param direction Unit, of the arriving ray.
/// @param normal Unit, on the side it comes from. @param front Whether that is the front.
template <ScatteringSet Possible>
Departure Scatter(const Roulette& material, std::uint32_t channel, const ScatteringSample& sample,
  const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  const RouletteChannel& shares = material.channels[channel];
  const std::uint64_t bits = sample.survival;
  Departure departure;
  if (bits < shares.diffuse)
  {
    departure.absorbed = false;
    departure.direction = ReflectDiffusely(normal, sample.u, sample.v);
    return departure;
  }
  if constexpr ((Possible & Reflections) != 0)
  {
    if (bits < shares.specular)
    {
      departure.absorbed = false;
      departure.how = Scattering::SpecularReflection;
      departure.direction = glm::normalize(direction - 2.0f * glm::dot(direction, normal) * normal);
      return departure;
    }
    if (bits < shares.glossy)
    {
      departure.absorbed = false;
      departure.how = Scattering::GlossyReflection;
      // The position of the number inside its share is a fresh uniform number.
      const auto place = static_cast<double>(bits - shares.specular) /
        static_cast<double>(shares.glossy - shares.specular);
      departure.direction =
        ReflectFromMicrofacets(-direction, normal, material.alpha, sample, place);
      return departure;
    }
  }
  if constexpr ((Possible & Transmissions) != 0)
  {
    if (bits < shares.through)
    {
      departure.absorbed = false;
      departure.how = Scattering::DiffuseTransmission;
      departure.sameSide = false;
      departure.direction = ReflectDiffusely(-normal, sample.u, sample.v);
      return departure;
    }
    if (material.clear)
    {
      return PassClear(material, shares.internal, sample.u, direction, normal, front);
    }
  }
  return departure;
}

} // namespace PhotonTransport
