// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/ScatteringSet.h"
#include "PhotonTransport/registration/Registration.h"

namespace PhotonTransport
{

/// The effects that are simulated if a scene calls for them.
struct EffectSettings
{
  Registration registration = Registration::VertexNormalised;
  /// Ways of scattering that are simulated where the scene has them. Photons that would take
  /// another way end there and are counted (PhotonBalance::switchedOff).
  ScatteringSet scatterings = AllScatterings;
  bool colour = true;            ///< Simulate colours, where there are any.
  bool registerBackSide = false; ///< Also register hits on the backs of facets.
  bool curvedSurface = false;    ///< The scene's surface is made by CurvedSurface.
};

} // namespace PhotonTransport
