// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"

namespace PhotonTransport
{

/// What happens to light at a facet; the same on both sides. Shares of the light that arrives, per
/// channel, each in [0, 1] and together at most 1; the rest is absorbed.
struct Material
{
  Colour diffuseReflectance{ 0.0f };   ///< Lambert's law.
  Colour specularReflectance{ 0.0f };  ///< As a mirror does.
  Colour glossyReflectance{ 0.0f };    ///< About the mirror direction, as wide as `roughness`.
  Colour diffuseTransmittance{ 0.0f }; ///< To the other side, by Lambert's law: a lamp shade.
  /// Straight on or refracted: of what the others leave, the part that would pass at normal
  /// incidence if nothing were reflected. Fresnel's reflection by `refractiveIndex` comes on top.
  Colour clearTransmittance{ 0.0f };

  /// Of the glossy lobe, (0, 1]: the GGX distribution's alpha is its square.
  float roughness = 0.3f;
  /// Of the clear part, relative to what surrounds it, [1, 4]; 1 reflects nothing.
  float refractiveIndex = 1.0f;
  /// The clear part is the surface of a body that bends light, its front being the outside;
  /// otherwise a thin pane with both its faces, which does not.
  bool solid = false;
};

} // namespace PhotonTransport
