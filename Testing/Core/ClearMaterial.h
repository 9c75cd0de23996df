// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Material.h"

/// A pane, or the surface of a clear body. @param transmittance Within it.
inline PhotonTransport::Material Clear(
  const PhotonTransport::Colour& transmittance, float index, bool solid)
{
  PhotonTransport::Material material;
  material.clearTransmittance = transmittance;
  material.refractiveIndex = index;
  material.solid = solid;
  return material;
}
