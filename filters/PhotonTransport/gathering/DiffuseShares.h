// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/materials/Material.h"

#include <vector>

namespace PhotonTransport
{

/// What a material sends back and lets through diffusely, by channel, as far as it is simulated.
struct DiffuseShares
{
  Colour reflected{ 0.0f };
  Colour through{ 0.0f };

  DiffuseShares(const Material& material, const Effects& effects)
  {
    const auto share = [&](const Colour& colour, Scattering way)
    {
      const bool on = (effects.simulated & SetOf(way)) != 0;
      return !on ? Colour(0.0f) : effects.colouredFacets ? colour : Colour(Luminous(colour));
    };
    this->reflected = share(material.diffuseReflectance, Scattering::DiffuseReflection);
    this->through = share(material.diffuseTransmittance, Scattering::DiffuseTransmission);
  }

  bool IsBlack() const { return this->reflected == Colour(0.0f) && this->through == Colour(0.0f); }
  bool IsTranslucent() const { return this->through != Colour(0.0f); }
};

inline std::vector<DiffuseShares> SharesOf(
  const std::vector<Material>& materials, const Effects& effects)
{
  std::vector<DiffuseShares> shares;
  shares.reserve(materials.size());
  for (const Material& material : materials)
  {
    shares.emplace_back(material, effects);
  }
  return shares;
}

} // namespace PhotonTransport
