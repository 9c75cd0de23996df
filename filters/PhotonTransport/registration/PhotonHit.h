// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/scene/Ray.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The end of one segment of a photon, as an entry of a photon map.
struct PhotonHit
{
  std::uint64_t photon; ///< Its index in its sequence.
  std::uint32_t facet;  ///< Of the scene; NoFacet where the photon left the scene.
  glm::vec3 barycentric;
  glm::vec3 direction;       ///< In which the photon flew, unit.
  std::uint32_t scatterings; ///< Of the photon before.
  std::uint32_t source;      ///< See Emitter.
  Colour shares;             ///< See PhotonOrigin.
  bool front;                ///< Whether it arrived on the facet's front.

  bool HasEscaped() const { return this->facet == NoFacet; }
};

/// A photon map: hits one by one, in the order of photons and along each path.
struct StoredPhotons
{
  std::vector<PhotonHit> hits; ///< Without escapes.
  /// How many photons they are of, whether or not they have hit anything. Each stands for the flux
  /// of the lamps over this number, times the start weight of its source.
  std::uint64_t photons = 0;
};

/// Where one photon flew.
struct PhotonPath
{
  Ray start;
  std::vector<PhotonHit> hits; ///< The last one is an escape where the photon left the scene.
};

} // namespace PhotonTransport
