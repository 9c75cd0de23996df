// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/openings/FindOpenings.h"
#include "PhotonTransport/transport/TraceSettings.h"

namespace PhotonTransport
{

/// Whether a sky shines.
bool HasSky(const Lighting& lighting);

/// Whether light from afar comes that the method has a use of openings for: that of skies, and
/// parallel light in Method::PhotonTracing.
bool UsesOpenings(const Lighting& lighting, const TraceSettings& settings);

/// The openings through which light from afar enters, for IlluminationRun: none
/// unless UsesOpenings. @param surface What the scene was made of.
FoundOpenings OpeningsToSkies(const Surface& surface, const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings);

} // namespace PhotonTransport
