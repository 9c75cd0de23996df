// SPDX-License-Identifier: BSD-3-Clause
// What a run has found: its maps and its flux.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/statistics/FacetError.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/PhotonFollower.h"
#include "PhotonTransport/transport/SecondPass.h"

#include <algorithm>
#include <functional>

namespace PhotonTransport
{

IlluminationMap IlluminationRun::Front() const
{
  IlluminationMap map = this->MapOf(&ReplicateSums::front);
  if (this->Second)
  {
    return this->Second->Together({ std::move(map), this->Second->Front(), this->LightFactor });
  }
  return map; // apart, since a choice between the two would copy it
}

IlluminationMap IlluminationRun::Back() const
{
  IlluminationMap map = this->MapOf(&ReplicateSums::back);
  if (this->Second)
  {
    return this->Second->Together({ std::move(map), this->Second->Back(), this->LightFactor });
  }
  return map;
}

std::vector<double> IlluminationRun::FacetErrorOf(const IlluminationMap& map) const
{
  std::vector<double> error;
  if (!this->Second)
  {
    Threads(this->Settings.threads)
      .Run(
        [&]
        {
          error = FacetError(this->LitScene, map.Totals(), map.standardError,
            this->Settings.registration != Registration::Flat);
        });
  }
  return error;
}

GroupMeans IlluminationRun::FrontByGroups() const
{
  return this->Second ? GroupMeans() : this->Sums.FrontByGroups(this->Scale(), this->Factors);
}

std::vector<std::array<double, 3>> IlluminationRun::FrontByColour() const
{
  if (this->EffectsNow.colour && this->Tracer.LampsTellColours())
  {
    return this->ColoursOfLamps(
      [](const IlluminationMap& map, std::size_t v) { return map.Total(v); });
  }
  std::vector<std::array<double, 3>> front = this->Sums.FrontByColour(this->Scale(), this->Factors);
  if (this->Second)
  {
    return this->Second->Together({ std::move(front), this->Second->Front(), this->LightFactor });
  }
  return front;
}

std::vector<std::array<double, 3>> IlluminationRun::ColourErrors() const
{
  if (this->Second || !this->EffectsNow.colour)
  {
    return {};
  }
  return this->Tracer.LampsTellColours()
    ? this->ColoursOfLamps(
        [](const IlluminationMap& map, std::size_t v) { return map.standardError[v]; })
    : this->Sums.ColourErrors(this->Scale(), this->Factors);
}

/// What photons have registered.
std::vector<double> IlluminationRun::LampAlone(std::size_t lamp) const
{
  return this->Settings.lampsApart ? this->MapOfLamp(lamp).Totals()
                                   : std::vector<double>(this->LitScene.VertexAreas().size(), 0.0);
}

std::vector<double> IlluminationRun::FrontOfLamp(std::size_t lamp) const
{
  std::vector<double> front = this->LampAlone(lamp);
  if (this->Second)
  {
    return this->Second->Together(
      { std::move(front), this->Second->Front(), this->LightFactor }, lamp);
  }
  return front;
}

StoredPhotons IlluminationRun::Photons(
  std::uint64_t most, const std::function<bool(std::uint64_t hits)>& goOn) const
{
  std::vector<std::uint64_t> blocks;
  for (std::uint32_t r = 0; r < this->Sums.replicates.size(); ++r)
  {
    blocks.push_back(this->BlocksOf(r));
  }
  return PhotonFollower(this->LitScene, this->Tracer, this->Settings).Hits(blocks, most, goOn);
}

std::vector<PhotonPath> IlluminationRun::Paths(std::uint64_t photons) const
{
  return PhotonFollower(this->LitScene, this->Tracer, this->Settings)
    .Paths(photons, this->BlocksOf(0));
}

std::uint32_t IlluminationRun::LampOf(std::uint32_t source) const
{
  return this->Tracer.Source().LampOf(source);
}

double IlluminationRun::FluxSwitchedOff(Scattering scattering) const
{
  return this->BalanceOfFlux().switchedOff[static_cast<unsigned>(scattering)];
}

double IlluminationRun::FluxOfPhoton(std::size_t source, std::uint64_t photons) const
{
  return photons > 0 ? this->Scale().flux / static_cast<double>(photons) *
      double{ this->Tracer.StartWeights()[source] } * this->FactorOf(source)
                     : 0.0;
}

double IlluminationRun::FluxOfPhoton(std::size_t source) const
{
  return this->FluxOfPhoton(source, this->Balance().emitted);
}

std::vector<Arrivals> IlluminationRun::ArrivalsByLamp() const
{
  const std::vector<Arrivals> bySource = this->Sums.ArrivalsBySource();
  std::vector<Arrivals> byLamp(this->Tracer.Source().Lamps());
  for (std::size_t source = 0; source < bySource.size(); ++source)
  {
    byLamp[source % byLamp.size()] += bySource[source];
  }
  return byLamp;
}

/// @param ofPhoton What a photon of a source counts.
std::vector<ArrivedFlux> IlluminationRun::ArrivedByLamp(
  const std::function<double(std::size_t source)>& ofPhoton) const
{
  const std::vector<Arrivals> bySource = this->Sums.ArrivalsBySource();
  std::vector<ArrivedFlux> byLamp(this->Tracer.Source().Lamps());
  for (std::size_t source = 0; source < bySource.size(); ++source)
  {
    byLamp[source % byLamp.size()].AddTimes(ofPhoton(source), bySource[source]);
  }
  return byLamp;
}

std::vector<ArrivedFlux> IlluminationRun::FluxArrivedByLamp() const
{
  return this->ArrivedByLamp([this](std::size_t source) { return this->FluxOfPhoton(source); });
}

std::vector<ArrivedFlux> IlluminationRun::SquaredFluxArrivedByLamp() const
{
  return this->ArrivedByLamp(
    [this](std::size_t source)
    {
      const double flux = this->FluxOfPhoton(source);
      return flux * flux;
    });
}

ShareOfLight IlluminationRun::ScatteredLightOnBacks() const
{
  const Emitter& lamps = this->Tracer.Source();
  const std::vector<Arrivals> arrivals = this->Sums.ArrivalsBySource();
  const std::vector<PhotonBalance> balances = this->Sums.BalancesBySource();
  ShareOfLight share;
  for (std::size_t source = 0; source < balances.size(); ++source)
  {
    const bool outdoors = lamps.PartOf(source) == LightPart::Whole &&
      lamps.HandsOver(static_cast<std::uint32_t>(source), true);
    const PhotonBalance& balance = balances[source];
    const Arrivals& first = arrivals[source];
    // Numbers come first, since their differences are exact.
    const std::uint64_t met =
      (balance.segments - balance.escaped) - (first.Emitted() - first.escaped);
    if (outdoors || met == 0)
    {
      continue;
    }
    const auto onBacks = static_cast<double>(balance.onBacks - first.back);
    const auto all = static_cast<double>(met);
    const double flux = this->FluxOfPhoton(source);
    // A photon counts each time, and where it does once it is likely to do so again.
    const auto photons = static_cast<double>(first.front + first.back + first.elsewhere);
    const double square = flux * flux * std::max(1.0, all / std::max(1.0, photons));
    share.part += flux * onBacks;
    share.whole += flux * all;
    share.squaredPart += square * onBacks;
    share.squaredWhole += square * all;
  }
  return share;
}

FluxBalance IlluminationRun::BalanceOfFlux() const
{
  const std::vector<PhotonBalance> bySource = this->Sums.BalancesBySource();
  FluxBalance all;
  for (std::size_t source = 0; source < bySource.size(); ++source)
  {
    all.AddTimes(this->FluxOfPhoton(source), bySource[source]);
  }
  return all;
}

double IlluminationRun::FluxOf(std::uint64_t photons) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  return emitted > 0.0 ? this->Flux() / emitted * static_cast<double>(photons) : 0.0;
}

double IlluminationRun::FluxCutByWeightBound() const
{
  const std::vector<double> cut = this->Sums.CutByWeightBound();
  double flux = 0.0;
  for (std::size_t source = 0; source < cut.size(); ++source)
  {
    flux += this->FluxOfPhoton(source) * cut[source];
  }
  return flux;
}

} // namespace PhotonTransport
