// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/Scattering.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// The edges of one channel's shares. The first is as Survives() would have it, to the bit.
RouletteChannel MakeChannel(float diffuse, float specular, float glossy, float through, float clear)
{
  const auto edge = [](double share)
  { return static_cast<std::uint64_t>(std::min(share, 1.0) * 0x1p32); };
  const double afterSpecular = double{ diffuse } + specular;
  const double afterGlossy = afterSpecular + glossy;
  const double afterThrough = afterGlossy + through;
  const double rest = 1.0 - afterThrough;
  const double internal = clear > 0.0f && rest > 0.0 ? std::min(1.0, clear / rest) : 0.0;
  return { edge(diffuse), edge(afterSpecular), edge(afterGlossy), edge(afterThrough),
    static_cast<float>(internal) };
}

bool Any(const Colour& share)
{
  return share.x > 0.0f || share.y > 0.0f || share.z > 0.0f;
}

} // namespace

Roulette MakeRoulette(const Material& material, bool colour)
{
  Roulette roulette{ {}, !colour || !IsColoured(material), material.roughness * material.roughness,
    material.refractiveIndex, Any(material.clearTransmittance), material.solid,
    (ScatteringsOf(material) & Transmissions) != 0 };
  for (int c = 0; c < 3; ++c)
  {
    const auto channel = [&](const Colour& share) { return colour ? share[c] : Luminous(share); };
    roulette.channels[static_cast<std::size_t>(c)] =
      MakeChannel(channel(material.diffuseReflectance), channel(material.specularReflectance),
        channel(material.glossyReflectance), channel(material.diffuseTransmittance),
        channel(material.clearTransmittance));
  }
  return roulette;
}

bool IsColoured(const Material& material)
{
  return std::any_of(MaterialProperties.begin(), MaterialProperties.end(),
    [&](const MaterialProperty& property)
    {
      const auto* share = std::get_if<Colour Material::*>(&property.member);
      return share && !IsGrey(material.**share);
    });
}

ScatteringSet ScatteringsOf(const Material& material)
{
  ScatteringSet set = 0;
  const auto add = [&](Scattering scattering, const Colour& share)
  { set |= Any(share) ? SetOf(scattering) : 0u; };
  add(Scattering::DiffuseReflection, material.diffuseReflectance);
  add(Scattering::SpecularReflection, material.specularReflectance);
  add(Scattering::GlossyReflection, material.glossyReflectance);
  add(Scattering::DiffuseTransmission, material.diffuseTransmittance);
  add(material.solid ? Scattering::Refraction : Scattering::ClearTransmission,
    material.clearTransmittance);
  return set;
}

} // namespace PhotonTransport
