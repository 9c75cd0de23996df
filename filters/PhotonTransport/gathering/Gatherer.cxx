// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/Gatherer.h"

#include "PhotonTransport/gathering/StrataVariance.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/Strata.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Beyond so many strata a probe finds little more.
constexpr double MostProbeRays = 576.0;

} // namespace

std::size_t GatherEffort::StrataFor(double rays)
{
  return std::max<std::size_t>(4, 2 * static_cast<std::size_t>(std::lround(0.5 * std::sqrt(rays))));
}

GatherEffort::GatherEffort(std::uint32_t rays)
  : probe(StrataFor(std::min(0.5 * rays, MostProbeRays)))
  , guided(StrataFor(std::max(0.5 * rays, rays - MostProbeRays)))
  , opening(StrataFor(0.25 * rays))
  , lampSamples(std::clamp(rays / 8u, 8u, 256u))
{
}

double GatherEffort::ShareOfProbe() const
{
  const auto probeRays = static_cast<double>(this->probe * this->probe);
  const auto guidedRays = static_cast<double>(this->guided * this->guided);
  constexpr double WorthOfProbe = 0.4; // a probing ray tells so much less than a guided one
  return WorthOfProbe * probeRays / (probeRays + guidedRays);
}

double Gatherer::Receive(const Receiver& at, std::uint64_t receiver, ReceivedLight& light)
{
  light.Clear(this->Exitance.Replicates(), this->Exitance.lamps);
  if (at.starts.empty())
  {
    return 0.0;
  }
  double variance = this->AddLamps(at, receiver, light);
  const double share = this->Effort.ShareOfProbe();
  variance += this->GatherThroughOpenings(at, receiver, light);
  variance += this->Probe(at, receiver, share, light);
  variance += this->GatherGuided(at, receiver, 1.0 - share, light);
  return variance;
}

double Gatherer::AddLamps(const Receiver& at, std::uint64_t receiver, ReceivedLight& light)
{
  this->Gathered.lamps.At(
    at, this->Effort.lampSamples, this->Gathered.seed, receiver, this->OfLamps);
  for (std::size_t lamp = 0; lamp < this->OfLamps.ofLamp.size(); ++lamp)
  {
    // A lamp whose middle is hidden may come out a little below 0; see DirectLight::At. It is 0 in
    // all sums alike, so that they agree.
    const glm::dvec3 lux(glm::max(this->OfLamps.ofLamp[lamp], 0.0f));
    light.channels += lux;
    light.direct += lux.x + lux.y + lux.z;
    if (!light.ofLamps.empty())
    {
      light.ofLamps[lamp] += lux.x + lux.y + lux.z;
    }
  }
  return this->OfLamps.variance;
}

double Gatherer::Probe(
  const Receiver& at, std::uint64_t receiver, double share, ReceivedLight& light)
{
  const GatherSequence sequence{ ReceiverStream::Probe, receiver };
  const std::size_t side = this->Effort.probe;
  const Frame frame(at.normal);
  this->Rays.clear();
  this->Factors.clear();
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    this->AddRay(at, frame.ToWorld(CosineHemisphere(place.x, place.y)),
      share / static_cast<double>(side * side));
  }
  this->Follow({ LightThrough::NoOpening }, sequence, light);
  this->Directions.Set(side, this->Reader.ExpectedOfRays());
  this->Onwards.Set(this->Directions, frame, this->Reader.FollowedRays());
  return this->VarianceOfRays(side);
}

double Gatherer::GatherGuided(
  const Receiver& at, std::uint64_t receiver, double share, ReceivedLight& light)
{
  const GatherSequence sequence{ ReceiverStream::Guided, receiver };
  const std::size_t side = this->Effort.guided;
  const Frame frame(at.normal);
  const double ofRay = share / static_cast<double>(side * side);
  this->Rays.clear();
  this->Factors.clear();
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    const GuidedPlace guided = this->Directions.At(place.x, place.y);
    this->AddRay(
      at, frame.ToWorld(CosineHemisphere(guided.place.x, guided.place.y)), ofRay / guided.density);
  }
  this->Follow({ LightThrough::NoOpening }, sequence, light, &this->Onwards);
  return this->VarianceOfRays(side);
}

/// Light that comes straight through openings, from the sky or from what stands outside. Each
/// opening has directions of its own, the more the larger it is seen.
double Gatherer::GatherThroughOpenings(
  const Receiver& at, std::uint64_t receiver, ReceivedLight& light)
{
  const SeenOpenings seen(this->Gathered.openings, glm::vec3(at.Middle()));
  double variance = 0.0;
  for (std::uint32_t o = 0; o < this->Gathered.openings.List().size(); ++o)
  {
    if (seen[o].SolidAngle() > 0.0)
    {
      const double share = seen[o].SolidAngle() / seen.SolidAngle();
      const auto rays = static_cast<double>(this->Effort.opening * this->Effort.opening);
      variance +=
        this->GatherThrough(o, seen[o], GatherEffort::StrataFor(share * rays), at, receiver, light);
    }
  }
  return variance;
}

/// @param side Strata along each side of a square of places of the opening.
double Gatherer::GatherThrough(std::uint32_t opening, const SeenOpening& seen, std::size_t side,
  const Receiver& at, std::uint64_t receiver, ReceivedLight& light)
{
  this->Rays.clear();
  this->Factors.clear();
  const GatherSequence sequence{ ReceiverStream::Openings, receiver * MostOpenings + opening };
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    const OpeningSample sample = seen.Sample(place.x, place.y);
    // What rays find is the light of directions that are distributed as the cosine over pi.
    const double factor = FactorOf(sample.direction, double{ sample.weight }, at.normal) /
      static_cast<double>(side * side);
    this->AddRay(at, sample.weight > 0.0f ? sample.direction : glm::vec3(0.0f), factor);
  }
  this->Follow({ opening }, sequence, light);
  return this->VarianceOfRays(side);
}

/// Adds the light of all rays.
void Gatherer::Follow(const LightThrough& through, const GatherSequence& sequence,
  ReceivedLight& light, NearGuide* onwards)
{
  this->Reader.Start(this->Factors, light);
  this->Through.assign(this->Rays.size(), through);
  this->Walk.Follow(this->Rays, this->Through, sequence, this->Reader, onwards);
}

/// @param direction Zero for a ray that is left out. @param factor By which what it finds counts.
void Gatherer::AddRay(const Receiver& at, const glm::vec3& direction, double factor)
{
  const glm::vec3* start = at.StartTowards(direction);
  this->Rays.push_back(start ? Ray{ *start, direction } : Ray{ {}, glm::vec3(0.0f) });
  this->Factors.push_back(static_cast<float>(factor));
}

/// Of the sum of the rays' light. The noise of the first pass, which the spread of its replicates
/// tells, is kept out of it: it differs between the even and the odd replicates, by which the two
/// factors of the squares are found.
double Gatherer::VarianceOfRays(std::size_t side) const
{
  const std::vector<glm::vec2>& found = this->Reader.FoundByRays();
  const auto at = [&](std::size_t i) { return double{ this->Factors[i] } * glm::dvec2(found[i]); };
  double squares = 0.0;
  ForEachThreeStrata(side,
    [&](std::size_t a, std::size_t b, std::size_t c)
    {
      const glm::dvec2 difference = at(a) - 2.0 * at(b) + at(c);
      squares += difference.x * difference.y;
    });
  return VarianceOfStrata(side, squares);
}

} // namespace PhotonTransport
