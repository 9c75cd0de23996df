// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace PhotonTransport
{

/// One photon's start.
struct Emission
{
  Ray ray;
  std::uint32_t lamp = 0;    ///< Which of the lighting's luminaires.
  std::uint32_t channel = 0; ///< Which colour, where photons have one.
};

/// All lamps made ready: emits photons in the scene's coordinates, from each lamp as many as its
/// share of the flux.
class Emitter
{
public:
  /// Throws InvalidInput for a lamp that makes no sense (names the value, and the lamp if it has a
  /// name). @param scene Must outlive the emitter. @param colour Whether photons carry a channel.
  Emitter(const Lighting& lighting, const Scene& scene, bool colour = false);

  /// Total luminous flux of the photons, lm. For light from outside: what enters the disk or ball
  /// from which photons start.
  double Flux() const { return this->TotalFlux; }

  std::size_t Lamps() const { return this->Emitters.size(); }

  Emission Emit(const PhotonSample& sample) const
  {
    Emission emission;
    Share share;
    if (this->Emitters.size() > 1)
    {
      const std::size_t lamp = this->Table.At(share.PlaceOf(sample));
      share = { this->Table.Begin(lamp), this->Table.End(lamp) - this->Table.Begin(lamp) };
      emission.lamp = static_cast<std::uint32_t>(lamp);
    }
    emission.ray = std::visit([&](const auto& emitter) { return emitter.Emit(sample, share); },
      this->Emitters[emission.lamp]);
    if (!this->ChannelEnds.empty())
    {
      emission.channel = this->ChooseChannel(sample, emission.lamp, share);
    }
    return emission;
  }

private:
  std::uint32_t ChooseChannel(
    const PhotonSample& sample, std::uint32_t lamp, const Share& share) const;

  std::vector<LampEmitter> Emitters;
  FluxTable Table; ///< Chooses the lamp, where there are several.
  /// [lamp] Shares of red, of red and green, and of all in the lamp's flux; empty without colour.
  std::vector<Colour> ChannelEnds;
  double TotalFlux = 0.0;
};

} // namespace PhotonTransport
