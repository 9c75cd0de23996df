// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/lights/OpeningEmitters.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstdint>
#include <memory>
#include <new>
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
    this->Emit(&sample, 1, &emission.ray,
      [&](std::size_t, std::uint32_t source, const Colour& shares)
      {
        emission.source = source;
        emission.shares = shares;
      });
    return emission;
  }

  /// Emits a photon for each sample. @param rays Takes their rays.
  /// @param store Called as store(i, source, shares), see Emission, for each photon in turn.
  template <typename Store>
  void Emit(const PhotonSample* samples, std::size_t count, Ray* rays, const Store& store) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      std::uint32_t source = 0;
      Share share;
      if (this->StartWeightOfSource.size() > 1)
      {
        source = static_cast<std::uint32_t>(this->Table.At(share.PlaceOf(samples[i])));
        share = { this->Table.Begin(source), this->Table.End(source) - this->Table.Begin(source) };
      }
      this->EmitFrom(source, samples[i], share, rays[i]);
      store(i, source, this->ColourOf(source, samples[i], share));
    }
  }

  /// A photon of one source alone.
  Emission EmitOf(const PhotonSample& sample, std::uint32_t source) const
  {
    Emission emission;
    emission.source = source;
    this->EmitFrom(source, sample, Share(), emission.ray);
    emission.shares = this->ColourOf(source, sample, Share());
    return emission;
  }

private:
  /// The ray is made in its place, since a copy would wait for what was just written.
  void EmitFrom(
    std::uint32_t source, const PhotonSample& sample, const Share& share, Ray& ray) const
  {
    if (source < this->Emitters.size())
    {
      std::visit([&](const auto& emitter) { ::new (&ray) Ray(emitter.Emit(sample, share)); },
        this->Emitters[source]);
    }
    else
    {
      ::new (&ray) Ray(this->ThroughOpenings(source)->Emit(sample, share));
    }
  }
  void AddParts();
  Colour ColourOf(std::uint32_t source, const PhotonSample& sample, const Share& share) const
  {
    if (this->SharesOfLamps.empty())
    {
      return this->ChannelShares(0);
    }
    const std::uint32_t lamp = this->LampOf(source);
    return this->ChannelShares(lamp,
      std::visit([&](const auto& emitter) { return emitter.OwnColour(sample, share); },
        this->Emitters[lamp]));
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
