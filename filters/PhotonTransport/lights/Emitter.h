// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/lights/OpeningEmitters.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace PhotonTransport
{

/// One photon's start.
struct Emission
{
  /// The photon's way; from a source at an opening, the way out, see OpeningEmitter::Emit.
  Ray ray;
  std::uint32_t source = 0;          ///< See Emitter.
  Colour shares{ 1.0f, 0.0f, 0.0f }; ///< See Emitter::ChannelShares.
};

/// All lamps made ready: emits photons in the scene's coordinates.
///
/// A source is one lamp's LightPart: source number part * Lamps() + lamp. Each source emits as many
/// photons as its share of the flux, unless shares of the photons are set. Then a photon counts by
/// its start weight, the share of the flux over the share of the photons.
class Emitter
{
public:
  /// Throws InvalidInput for a lamp that makes no sense (names the value, and the lamp if it has a
  /// name). @param scene Must outlive the emitter. @param colour Whether photons have colours.
  /// @param openings Through which light from afar enters: if there are any, lamps get the other
  /// parts of their light.
  Emitter(
    const Lighting& lighting, const Scene& scene, bool colour = false, Openings openings = {});

  Emitter(const Emitter&) = delete; // parts of lamps know the openings
  Emitter& operator=(const Emitter&) = delete;

  /// Total luminous flux of the photons, lm. For light from outside: what enters the disk or ball
  /// from which photons start.
  double Flux() const { return this->TotalFlux; }

  std::size_t Lamps() const { return this->Emitters.size(); }
  const LampEmitter& OfLamp(std::size_t lamp) const { return this->Emitters[lamp]; }
  /// Luminous flux of a lamp's photons, lm; see Prepared.
  double Flux(std::size_t lamp) const { return this->Fluxes[lamp]; }

  /// Lamps(), or LightParts times as many if light comes through openings.
  std::size_t Sources() const { return this->StartWeightOfSource.size(); }
  std::uint32_t LampOf(std::uint32_t source) const
  {
    return source % static_cast<std::uint32_t>(this->Lamps());
  }
  LightPart PartOf(std::size_t source) const
  {
    return static_cast<LightPart>(source / this->Lamps());
  }
  /// Of all photons of a source, lm, those included that are not kept.
  double FluxOfSource(std::size_t source) const { return this->SourceFluxes[source]; }
  /// [source] With them light adds up as if each photon had Flux() over the number of photons. 0
  /// for sources without photons.
  const std::vector<float>& StartWeights() const { return this->StartWeightOfSource; }
  const Openings& ToSky() const { return this->OpeningsToSky; }
  /// Null for sources that are no part through openings, or a dark one.
  const OpeningEmitter* ThroughOpenings(std::size_t source) const
  {
    return source < this->Lamps() ? nullptr : this->Through[source - this->Lamps()].get();
  }

  /// Whether another part has the light of a lamp's Whole that comes to an opening.
  /// @param straight Whether it comes straight from the lamp, or through panes.
  bool HandsOver(std::uint32_t lamp, bool straight) const
  {
    const auto part = straight ? LightPart::Straight : LightPart::Scattered;
    return this->Sources() > this->Lamps() &&
      this->Through[(static_cast<std::size_t>(part) - 1) * this->Lamps() + lamp];
  }

  /// Gives each source a share of the photons, whatever its flux. @param shares [source] >= 0;
  /// above 0 where the flux is.
  void SetPhotonShares(const std::vector<double>& shares);

  /// Shares of red, green and blue in luminous flux, together 1; without colour all is in the
  /// first.
  /// @param own The colour of the place on the lamp, if it has one; see LampKind.h.
  Colour ChannelShares(std::size_t lamp, const Colour* own = nullptr) const;

  Emission Emit(const PhotonSample& sample) const
  {
    Emission emission;
    Share share;
    if (this->StartWeightOfSource.size() > 1)
    {
      const std::size_t source = this->Table.At(share.PlaceOf(sample));
      share = { this->Table.Begin(source), this->Table.End(source) - this->Table.Begin(source) };
      emission.source = static_cast<std::uint32_t>(source);
      if (source >= this->Emitters.size())
      {
        return this->EmitThroughOpening(sample, emission.source, share);
      }
    }
    return this->EmitFrom(sample, emission.source, share);
  }

  /// A photon of one source alone.
  Emission EmitOf(const PhotonSample& sample, std::uint32_t source) const
  {
    return source < this->Emitters.size() ? this->EmitFrom(sample, source, Share())
                                          : this->EmitThroughOpening(sample, source, Share());
  }

private:
  Emission EmitFrom(const PhotonSample& sample, std::uint32_t lamp, const Share& share) const
  {
    Emission emission;
    emission.source = lamp;
    emission.ray = std::visit(
      [&](const auto& emitter) { return emitter.Emit(sample, share); }, this->Emitters[lamp]);
    this->GiveColour(emission, sample, share);
    return emission;
  }
  Emission EmitThroughOpening(
    const PhotonSample& sample, std::uint32_t source, const Share& share) const;
  void AddParts();
  void GiveColour(Emission& emission, const PhotonSample& sample, const Share& share) const
  {
    if (!this->SharesOfLamps.empty())
    {
      const std::uint32_t lamp = this->LampOf(emission.source);
      emission.shares = this->ChannelShares(lamp,
        std::visit([&](const auto& emitter) { return emitter.OwnColour(sample, share); },
          this->Emitters[lamp]));
    }
  }

  std::vector<LampEmitter> Emitters;
  std::vector<double> Fluxes;
  FluxTable Table; ///< Chooses the source, where there are several.
  Openings OpeningsToSky;
  /// [source - Lamps()] Or null.
  std::vector<std::shared_ptr<const OpeningEmitter>> Through;
  std::vector<double> SourceFluxes;
  std::vector<float> StartWeightOfSource;
  std::vector<Colour> SharesOfLamps; ///< [lamp] Empty without colour.
  double TotalFlux = 0.0;
};

} // namespace PhotonTransport
