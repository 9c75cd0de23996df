// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Scattering.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Materials in the form that photons need, by facet. Both are empty where photons need none.
struct FacetRoulettes
{
  std::vector<Roulette> roulettes;
  std::vector<std::uint32_t> ofFacet;
};

/// @param materialOfFacet Which of the materials, by facet. @param colour See MakeRoulette.
inline FacetRoulettes MakeRoulettes(const std::vector<Material>& materials,
  const std::vector<std::uint32_t>& materialOfFacet, bool colour)
{
  FacetRoulettes made{ {}, materialOfFacet };
  made.roulettes.reserve(materials.size());
  for (const Material& material : materials)
  {
    made.roulettes.push_back(MakeRoulette(material, colour));
  }
  return made;
}

} // namespace PhotonTransport
