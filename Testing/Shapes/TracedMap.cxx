// SPDX-License-Identifier: BSD-3-Clause
#include "TracedMap.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;

namespace
{

// Equal is the same to the last bit here, as no value is NaN and none is -0.

bool SameBits(const IlluminationMap& a, const IlluminationMap& b)
{
  return a.direct == b.direct && a.indirect == b.indirect && a.standardError == b.standardError &&
    a.photonHits == b.photonHits && a.caustic == b.caustic;
}

bool SameCounts(const PhotonBalance& a, const PhotonBalance& b)
{
  return a.emitted == b.emitted && a.absorbed == b.absorbed && a.escaped == b.escaped &&
    a.cutOff == b.cutOff && a.handedOver == b.handedOver && a.blocked == b.blocked &&
    a.segments == b.segments && a.onBacks == b.onBacks && a.switchedOff == b.switchedOff;
}

} // namespace

std::size_t MostFacetsInOnePlace(const Scene& scene)
{
  const SharedPlaceNotes& shared = scene.Notes().sharedPlaces;
  return shared.copies.facets + shared.inPart.facets > 0 ? scene.Facets().size() : 1;
}

TracedMap::TracedMap(const Scene& given, const Lighting& lighting, const TraceSettings& settings,
  std::uint64_t photons, const Openings& openings)
  : TracedMap(ScenePointer(ScenePointer(), &given), lighting, settings, photons, openings)
{
}

TracedMap::TracedMap(const Surface& surface, const Lighting& lighting,
  const TraceSettings& settings, std::uint64_t photons)
  : TracedMap(std::make_shared<const Scene>(surface), lighting, settings, photons, Openings())
{
}

TracedMap::TracedMap(const ScenePointer& owned, const Lighting& lighting,
  const TraceSettings& settings, std::uint64_t photons, const Openings& openings)
  : Owned(owned)
  , scene(*owned)
{
  IlluminationRun run(this->scene, lighting, settings, openings);
  run.Advance({ photons });
  this->front = run.Front();
  this->frontByColour = run.FrontByColour();
  for (std::size_t lamp = 0; settings.lampsApart && lamp < lighting.luminaires.size(); ++lamp)
  {
    this->frontOfLamps.push_back(run.FrontOfLamp(lamp));
  }
  this->balance = run.Balance();
  this->effects = run.EffectsInUse();
  this->fluxCut = run.FluxCutByWeightBound();
  this->flux = run.Flux();
  const FluxBalance balanceOfFlux = run.BalanceOfFlux();
  this->fluxMet = balanceOfFlux.segments - balanceOfFlux.escaped;
  EXPECT_EQ(this->balance.emitted,
    this->balance.absorbed + this->balance.escaped + this->balance.cutOff +
      this->balance.handedOver + this->balance.blocked);
  this->ExpectSound(this->front);
  if (settings.registerBackSide)
  {
    this->back = run.Back();
    this->ExpectSound(this->back);
    if (settings.method == Method::PhotonTracing && openings.IsEmpty())
    {
      this->ExpectFluxWithinBounds(settings);
    }
  }
}

void TracedMap::ExpectSound(const IlluminationMap& side) const
{
  for (std::size_t v = 0; v < side.direct.size(); ++v)
  {
    ASSERT_TRUE(std::isfinite(side.direct[v]) && side.direct[v] >= 0.0) << "vertex " << v;
    ASSERT_TRUE(std::isfinite(side.indirect[v]) && side.indirect[v] >= 0.0) << "vertex " << v;
    ASSERT_TRUE(std::isfinite(side.standardError[v]) && side.standardError[v] >= 0.0) << v;
  }
}

void TracedMap::ExpectFluxWithinBounds(const TraceSettings& settings) const
{
  const double arrived = this->fluxMet;
  const double registered = this->RegisteredFlux(this->front) + this->RegisteredFlux(this->back);
  const double most = arrived * static_cast<double>(MostFacetsInOnePlace(this->scene));
  // Sums of floats are rounded to 2^-24, and three weights of a hit to 2^-28 of a mean photon each,
  // however little flux the photon has.
  const double hits = static_cast<double>(this->balance.segments - this->balance.escaped);
  const double rounded = 3.0 * 0x1p-28 * this->flux / static_cast<double>(this->balance.emitted) *
    hits * static_cast<double>(MostFacetsInOnePlace(this->scene));
  EXPECT_LE(registered, most * double{ settings.weightBound } * (1.0 + 1e-6) + rounded);
  if (settings.registration == Registration::Flat)
  {
    EXPECT_GE(registered, arrived * (1.0 - 1e-6) - rounded);
    EXPECT_LE(registered, most * (1.0 + 1e-6) + rounded);
  }
}

double TracedMap::RegisteredFlux(const IlluminationMap& side) const
{
  double sum = 0.0;
  for (std::size_t v = 0; v < side.direct.size(); ++v)
  {
    sum += this->scene.VertexAreas()[v] * (side.direct[v] + side.indirect[v]);
  }
  return sum;
}

double TracedMap::FluxError() const
{
  double square = 0.0;
  for (std::size_t v = 0; v < this->front.direct.size(); ++v)
  {
    square += std::pow(this->scene.VertexAreas()[v] * this->front.standardError[v], 2);
  }
  return std::sqrt(square);
}

bool TracedMap::HasTheBitsOf(const TracedMap& other) const
{
  return SameBits(this->front, other.front) && SameBits(this->back, other.back) &&
    this->frontByColour == other.frontByColour && this->frontOfLamps == other.frontOfLamps &&
    this->fluxCut == other.fluxCut && SameCounts(this->balance, other.balance);
}
