// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Warps.h"

#include <cstdint>

namespace PhotonTransport
{

/// Russian roulette (B. Barladian, "Indirect illumination on curve surfaces"): the photon survives
/// with unchanged energy, or disappears. Integers are compared, so that with reflectance 0 no
/// photon survives and with 1 every photon does.
inline bool Survives(float reflectance, std::uint32_t bits)
{
  return bits < static_cast<std::uint64_t>(reflectance * 0x1p32f);
}

/// A direction about the unit normal with the density of Lambert's law.
inline glm::vec3 ReflectDiffusely(const glm::vec3& normal, float u, float v)
{
  return Frame(normal).ToWorld(CosineHemisphere(u, v));
}

} // namespace PhotonTransport
