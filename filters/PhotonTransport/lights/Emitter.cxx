// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Emitter.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Shares of the channels in the luminous flux of light of a colour.
Colour SharesIn(const Colour& colour)
{
  const Colour flux = LuminousWeights * colour;
  const float sum = flux.x + flux.y + flux.z;
  return sum > 0.0f ? flux / sum : LuminousWeights;
}

void RequireColour(const Colour& colour)
{
  const float sum = colour.x + colour.y + colour.z;
  if (!(colour.x >= 0.0f && colour.y >= 0.0f && colour.z >= 0.0f && sum > 0.0f) ||
    !std::isfinite(sum))
  {
    throw InvalidInput(InvalidInput::Where::LampSettings, 0,
      "light colour (" + std::to_string(colour.x) + ", " + std::to_string(colour.y) + ", " +
        std::to_string(colour.z) + ") must be finite, >= 0 and not all 0");
  }
}

void RequireDimming(double dimming)
{
  if (!(dimming >= 0.0) || !std::isfinite(dimming))
  {
    throw InvalidInput(InvalidInput::Where::LampSettings, 0,
      "dimming " + std::to_string(dimming) + " must be finite and >= 0");
  }
}

Prepared<LampEmitter> PreparedLamp(const Luminaire& luminaire, const Scene& scene)
{
  try
  {
    RequireColour(luminaire.colour);
    RequireDimming(luminaire.dimming);
    return std::visit(
      [&](const auto& lamp)
      {
        auto prepared = lamp.Prepare(scene);
        return Prepared<LampEmitter>{ std::move(prepared.emitter),
          luminaire.dimming * prepared.flux };
      },
      luminaire.lamp);
  }
  catch (const InvalidInput& error)
  {
    const std::string name = luminaire.name.empty() ? "" : "luminaire '" + luminaire.name + "': ";
    throw InvalidInput(error.Kind, error.Index, name + error.what());
  }
}

} // namespace

Emitter::Emitter(const Lighting& lighting, const Scene& scene, bool colour, Openings openings)
  : OpeningsToSky(std::move(openings))
{
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    Prepared<LampEmitter> prepared = PreparedLamp(luminaire, scene);
    this->Emitters.push_back(std::move(prepared.emitter));
    this->Fluxes.push_back(prepared.flux);
    this->TotalFlux += prepared.flux;
    if (colour)
    {
      this->SharesOfLamps.push_back(SharesIn(luminaire.colour));
    }
  }
  if (this->Fluxes.empty())
  {
    throw InvalidInput(InvalidInput::Where::LampSettings, 0, "there is no lamp");
  }
  if (this->Fluxes.size() > 1)
  {
    // If all lamps are dark, the first one emits photons without flux.
    std::vector<double> fluxes = this->Fluxes;
    fluxes.front() = this->TotalFlux > 0.0 ? fluxes.front() : 1.0;
    this->Table = FluxTable(fluxes);
  }
  this->SourceFluxes = this->Fluxes;
  this->StartWeightOfSource.assign(this->Fluxes.size(), 1.0f);
  if (!this->OpeningsToSky.IsEmpty() && this->TotalFlux > 0.0)
  {
    this->AddParts();
  }
}

/// The parts of lamps that come through openings, if there is one that does.
void Emitter::AddParts()
{
  for (const LightPart part : { LightPart::Straight, LightPart::Scattered })
  {
    for (const LampEmitter& lamp : this->Emitters)
    {
      this->Through.push_back(EmitterThroughOpenings(this->OpeningsToSky, lamp, part));
    }
  }
  if (std::none_of(
        this->Through.begin(), this->Through.end(), [](const auto& part) { return part; }))
  {
    this->Through.clear();
    return;
  }
  for (std::size_t i = 0; i < this->Through.size(); ++i)
  {
    this->SourceFluxes.push_back(
      this->Through[i] ? this->Through[i]->FluxPerLumen() * this->Fluxes[i % this->Lamps()] : 0.0);
  }
  this->SetPhotonShares(this->SourceFluxes);
}

void Emitter::SetPhotonShares(const std::vector<double>& shares)
{
  double sum = 0.0;
  for (const double share : shares)
  {
    sum += share;
  }
  this->Table = FluxTable(shares);
  this->StartWeightOfSource.clear();
  for (std::size_t source = 0; source < shares.size(); ++source)
  {
    const double ofPhotons = shares[source] / sum;
    const double ofFlux = this->SourceFluxes[source] / this->TotalFlux;
    this->StartWeightOfSource.push_back(
      ofPhotons > 0.0 ? static_cast<float>(ofFlux / ofPhotons) : 0.0f);
  }
}

Colour Emitter::ChannelShares(std::size_t lamp, const Colour* own) const
{
  if (this->SharesOfLamps.empty())
  {
    return { 1.0f, 0.0f, 0.0f };
  }
  return own ? SharesIn(*own) : this->SharesOfLamps[lamp];
}

} // namespace PhotonTransport
