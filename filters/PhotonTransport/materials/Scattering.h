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
  bool grey;                               ///< Whether they are.
  float alpha;
  float refractiveIndex;
  bool clear;
  bool solid;
  bool translucent; ///< Lets light through, in any way.
};

/// @param colour Whether photons have colours; otherwise all three channels are the luminous one.
Roulette MakeRoulette(const Material& material, bool colour);

/// What a material can do with light.
ScatteringSet ScatteringsOf(const Material& material);

/// Whether light passes straight on, as through a thin pane.
inline bool PassesStraightOn(const Material& material)
{
  return (ScatteringsOf(material) & SetOf(Scattering::ClearTransmission)) != 0;
}

/// Whether a material treats the channels unequally.
bool IsColoured(const Material& material);

/// Light that meets the clear part of a pane or of a body's surface.
class ClearBoundary
{
public:
  /// @param direction Unit, of the arriving ray. @param normal Unit, on the side it comes from.
  /// @param front Whether that is the front.
  ClearBoundary(
    const Roulette& material, const glm::vec3& direction, const glm::vec3& normal, bool front)
    : Direction(direction)
    , Normal(normal)
    , Solid(material.solid)
    , CosIn(std::min(1.0f, -glm::dot(direction, normal)))
    , Index(IndexOf(material, front))
    , Fresnel(this->CosIn, this->Index)
  {
  }

  Scattering How() const
  {
    return this->Solid ? Scattering::Refraction : Scattering::ClearTransmission;
  }
  /// Of the clear part's light. @param internal See RouletteChannel::internal.
  ReflectedAndTransmitted Shares(float internal) const
  {
    if (!this->Solid)
    {
      return ThinPane(this->Fresnel, internal);
    }
    const float reflected = this->Fresnel.Mean();
    return { reflected, (1.0f - reflected) * internal };
  }
  glm::vec3 Mirrored() const
  {
    return glm::normalize(this->Direction + 2.0f * this->CosIn * this->Normal);
  }
  glm::vec3 Passed() const
  {
    return this->Solid ? Refract(this->Direction, this->Normal, this->CosIn, this->Index,
                           std::max(this->Fresnel.cosine, 1e-6f))
                       : this->Direction;
  }
  /// By which radiance is divided that has come out of a body, or into it, against the direction of
  /// Passed(): radiance over the square of the refractive index stays the same along a ray.
  static float RadianceDivisor(const Roulette& body, bool front)
  {
    const float index = IndexOf(body, front);
    return index * index;
  }

private:
  static float IndexOf(const Roulette& material, bool front)
  {
    return material.solid && !front ? 1.0f / material.refractiveIndex : material.refractiveIndex;
  }

  glm::vec3 Direction, Normal;
  bool Solid;
  float CosIn;
  float Index; ///< Of the side behind the boundary relative to the side in front of it.
  FresnelReflectances Fresnel;
};

/// The clear part of a pane or of a body's surface.
inline Departure PassClear(const Roulette& material, float internal, float u,
  const glm::vec3& direction, const glm::vec3& normal, bool front)
{
  const ClearBoundary boundary(material, direction, normal, front);
  const ReflectedAndTransmitted share = boundary.Shares(internal);
  Departure departure;
  // A sum that rounds below 1 must not absorb where nothing does.
  departure.absorbed = internal < 1.0f && !(u < share.reflected + share.transmitted);
  departure.how = boundary.How();
  departure.sameSide = u < share.reflected;
  departure.undeflected = !departure.sameSide && !material.solid;
  departure.direction = departure.sameSide ? boundary.Mirrored() : boundary.Passed();
  return departure;
}

/// What becomes of a photon of unit energy: it goes on with all of it, or is absorbed.
/// @tparam Possible What is compiled in. @param shares Of the material's channels, the one that the
/// photon has. @param direction Unit, of the arriving ray.
/// @param normal Unit, on the side it comes from. @param front Whether that is the front.
template <ScatteringSet Possible>
Departure Scatter(const Roulette& material, const RouletteChannel& shares,
  const ScatteringSample& sample, const glm::vec3& direction, const glm::vec3& normal, bool front)
{
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
