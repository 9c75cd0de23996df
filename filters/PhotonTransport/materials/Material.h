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
  /// The share of the arriving light that would pass at normal incidence, straight on or refracted,
  /// if nothing were reflected. All light that the other shares leave meets the pane or the surface
  /// of the body; Fresnel's reflection by `refractiveIndex` takes its part of it first.
  Colour clearTransmittance{ 0.0f };

  /// Of the glossy lobe, (0, 1]. Its square is alpha of the GGX distribution.
  float roughness = 0.3f;
  /// Of the clear part, relative to its surroundings, [1, 4]; 1 reflects nothing.
  float refractiveIndex = 1.0f;
  /// True: the clear part is the surface of a body that bends light; its front is the outside.
  /// False: it is a thin pane with both its faces, which does not bend light.
  bool solid = false;
};

} // namespace PhotonTransport
