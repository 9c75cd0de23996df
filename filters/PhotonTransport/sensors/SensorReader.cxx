// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sensors/SensorReader.h"

#include "PhotonTransport/gathering/StrataVariance.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/openings/SeenOpenings.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

SensorReader::SensorReader(const GatherPass& pass, const SensorDirections& directions)
  : Pass(pass)
  , Directions(directions)
  , Gathered(pass.Through())
  , Exitance(pass.Exitance())
  , ShareOfHalf(SharesOfHalves(pass.Exitance()))
  , Walk(pass.Through())
  , Light(pass.Exitance())
{
}

void SensorReader::Read(
  const Receiver& at, const glm::dvec3& normal, std::uint64_t index, SensorReading& reading)
{
  reading = {};
  if (this->IsInsideSolid(at, index))
  {
    return;
  }
  this->Normal = normal;
  this->Lamps = this->VarianceOfLamps = this->VarianceOfRays = {};
  this->Glare = {};
  this->Gained.assign(this->Exitance.Replicates(), {});
  this->AddLamps(at, index);
  this->GatherThroughOpenings(at, index);
  this->Probe(at, index);
  this->GatherGuided(at, index);
  this->Store(reading);
}

/// By rays into all directions, in which backs of panes and of lamp shades do not count.
bool SensorReader::IsInsideSolid(const Receiver& at, std::uint64_t index)
{
  constexpr std::size_t Side = 12;
  std::array<Ray, Side * Side> rays;
  std::array<Hit, Side * Side> hits;
  const GatherSequence sequence{ ReceiverStream::Surroundings, index };
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, Side);
    rays[i] = { at.starts.front().origin, UniformSphere(place.x, place.y) };
  }
  const Scene& scene = this->Gathered.scene;
  scene.Intersect(rays.data(), hits.data(), rays.size());
  int backs = 0, others = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (hits[i])
    {
      const FacetRoulettes& materials = this->Gathered.materials;
      const Roulette& material = materials.roulettes[materials.ofFacet[hits[i].facet]];
      const bool front = glm::dot(rays[i].direction, scene.Facets()[hits[i].facet].normal) < 0.0f ||
        scene.PreferFront(rays[i], hits[i]);
      const bool back = !front && (!material.translucent || material.solid);
      (back ? backs : others)++;
    }
  }
  return backs > others;
}

void SensorReader::AddLamps(const Receiver& at, std::uint64_t index)
{
  using Glares = std::array<double, SensorDirections::Views>;
  this->Gathered.lamps.At(
    at, this->Pass.WithEffort().lampSamples, this->Gathered.seed, index, this->OfLamps);
  const std::vector<ArrivedLight>& arrived = this->OfLamps.arrived;
  Measured<double> before{};
  Glares glareBefore{};
  bool isSecond = false;
  for (const ArrivedLight& light : arrived)
  {
    const Measured<float> kernels =
      KernelsAt(glm::dvec3(light.towards), this->Normal, this->Directions);
    Measured<double> added;
    Glares glare{};
    this->AddGlare(light, glare);
    for (std::size_t k = 0; k < added.size(); ++k)
    {
      added[k] = kernels[k] * light.light;
      this->Lamps[k] += added[k];
      this->VarianceOfLamps[k] += isSecond ? std::pow(added[k] - before[k], 2.0) : 0.0;
    }
    for (std::size_t v = 0; v < glare.size(); ++v)
    {
      this->Glare[v].sum += glare[v];
      this->Glare[v].variance += isSecond ? std::pow(glare[v] - glareBefore[v], 2.0) : 0.0;
    }
    isSecond = light.paired && !isSecond;
    before = added;
    glareBefore = glare;
  }
}

/// L^2 domega / p^2, where L domega is the illuminance of a surface that faces the place. Each part
/// of a luminaire has a position index of its own.
void SensorReader::AddGlare(
  const ArrivedLight& light, std::array<double, SensorDirections::Views>& sums) const
{
  for (std::size_t v = 0; v < sums.size() && light.luminance > 0.0; ++v)
  {
    const double index =
      PositionIndex(glm::dvec3(light.towards), this->Directions.views[v], this->Directions.up);
    sums[v] += index > 0.0 ? light.luminance * light.light / (index * index) : 0.0;
  }
}

void SensorReader::Probe(const Receiver& at, std::uint64_t index)
{
  const GatherSequence sequence{ ReceiverStream::Probe, index };
  const std::size_t side = this->Pass.WithEffort().probe;
  const Frame frame{ glm::vec3(this->Directions.up) };
  // An even density of directions is 1 / (4 pi), and a ray finds pi times the luminance.
  const double ofRay = 4.0 * this->Pass.WithEffort().ShareOfProbe() / double(side * side);
  this->StartRays();
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    this->AddRay(at, frame.ToWorld(UniformSphere(place.x, place.y)), ofRay);
  }
  this->Follow({ LightThrough::NoOpening }, sequence, side);
  std::vector<float> found(side * side, 0.0f);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (std::size_t r = 0; r < this->Exitance.Replicates(); ++r)
    {
      found[i] += static_cast<float>(this->Exitance.shareOf[r]) * this->Light.Of(i)[r];
    }
  }
  this->ToLight.Set(side, found);
}

void SensorReader::GatherGuided(const Receiver& at, std::uint64_t index)
{
  const GatherSequence sequence{ ReceiverStream::Guided, index };
  const std::size_t side = this->Pass.WithEffort().guided;
  const Frame frame{ glm::vec3(this->Directions.up) };
  const double ofRay = 4.0 * (1.0 - this->Pass.WithEffort().ShareOfProbe()) / double(side * side);
  this->StartRays();
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    const GuidedPlace guided = this->ToLight.At(place.x, place.y);
    this->AddRay(at, frame.ToWorld(UniformSphere(guided.place.x, guided.place.y)),
      ofRay / double{ guided.density });
  }
  this->Follow({ LightThrough::NoOpening }, sequence, side);
}

void SensorReader::GatherThroughOpenings(const Receiver& at, std::uint64_t index)
{
  const SeenOpenings seen(this->Gathered.openings, at.starts.front().origin);
  for (std::uint32_t o = 0; o < this->Gathered.openings.List().size(); ++o)
  {
    if (seen[o].SolidAngle() > 0.0)
    {
      const double share = seen[o].SolidAngle() / seen.SolidAngle();
      const auto rays =
        static_cast<double>(this->Pass.WithEffort().opening * this->Pass.WithEffort().opening);
      this->GatherThrough(o, seen[o], GatherEffort::StrataFor(share * rays), at, index);
    }
  }
}

void SensorReader::GatherThrough(std::uint32_t opening, const SeenOpening& seen, std::size_t side,
  const Receiver& at, std::uint64_t index)
{
  this->StartRays();
  const GatherSequence sequence{ ReceiverStream::Openings, index * MostOpenings + opening };
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const glm::vec2 place = sequence.PlaceOf(this->Gathered.seed, i, side);
    const OpeningSample sample = seen.Sample(place.x, place.y);
    this->AddRay(at, sample.weight > 0.0f ? sample.direction : glm::vec3(0.0f),
      double{ sample.weight } / Pi / double(side * side));
  }
  this->Follow({ opening }, sequence, side);
}

void SensorReader::StartRays()
{
  this->Rays.clear();
  this->Weights.clear();
}

/// @param direction Zero for a ray that is left out. @param factor By which all kernels count.
void SensorReader::AddRay(const Receiver& at, const glm::vec3& direction, double factor)
{
  this->Rays.push_back({ at.starts.front().origin, direction });
  Measured<float> weights = KernelsAt(glm::dvec3(direction), this->Normal, this->Directions);
  for (float& weight : weights)
  {
    weight *= static_cast<float>(factor);
  }
  this->Weights.push_back(weights);
}

/// Adds the light of all rays, one in each stratum of a square.
void SensorReader::Follow(
  const LightThrough& through, const GatherSequence& sequence, std::size_t side)
{
  this->Through.assign(this->Rays.size(), through);
  this->Light.Start(this->Rays.size());
  this->Walk.Follow(this->Rays, this->Through, sequence, this->Light);
  this->Added.resize(this->Rays.size());
  for (std::size_t i = 0; i < this->Rays.size(); ++i)
  {
    const float* found = this->Light.Of(i);
    double halves[2] = { 0.0, 0.0 };
    for (std::size_t r = 0; r < this->Exitance.Replicates(); ++r)
    {
      halves[r % 2] += this->ShareOfHalf[r] * double{ found[r] };
      for (std::size_t k = 0; k < Measure::Number; ++k)
      {
        this->Gained[r][k] += double{ this->Weights[i][k] } * double{ found[r] };
      }
    }
    for (std::size_t half = 0; half < 2; ++half)
    {
      for (std::size_t k = 0; k < Measure::Number; ++k)
      {
        this->Added[i][half][k] = this->Weights[i][k] * static_cast<float>(halves[half]);
      }
    }
  }
  this->AddVariance(side);
}

/// See Gatherer::VarianceOfRays.
void SensorReader::AddVariance(std::size_t side)
{
  Measured<double> squares{};
  ForEachThreeStrata(side,
    [&](std::size_t a, std::size_t b, std::size_t c)
    {
      const auto difference = [&](std::size_t half, std::size_t k) {
        return this->Added[a][half][k] - 2.0f * this->Added[b][half][k] + this->Added[c][half][k];
      };
      for (std::size_t k = 0; k < Measure::Number; ++k)
      {
        squares[k] += double{ difference(0, k) * difference(1, k) };
      }
    });
  for (std::size_t k = 0; k < Measure::Number; ++k)
  {
    this->VarianceOfRays[k] += VarianceOfStrata(side, squares[k]);
  }
}

void SensorReader::Store(SensorReading& reading) const
{
  reading.valid = 1;
  const double unit = this->Pass.LuxOfUnit();
  Measured<double> byRays{}, errorByRays{};
  for (std::size_t k = 0; k < Measure::Number; ++k)
  {
    ReplicateStatistics statistics;
    for (std::size_t r = 0; r < this->Gained.size(); ++r)
    {
      statistics.Add(this->Gained[r][k], this->Exitance.shareOf[r]);
    }
    byRays[k] = unit * statistics.Mean();
    errorByRays[k] =
      unit * std::hypot(std::sqrt(this->VarianceOfRays[k]), statistics.StandardError());
    reading.lux[k] = unit * this->Lamps[k] + byRays[k];
    reading.standardError[k] =
      std::hypot(unit * std::sqrt(this->VarianceOfLamps[k]), errorByRays[k]);
  }
  for (std::size_t v = 0; v < reading.glare.size(); ++v)
  {
    const GlareSum glare{ std::pow(unit, 2.0) * this->Glare[v].sum,
      std::pow(unit, 4.0) * this->Glare[v].variance };
    reading.glare[v] =
      RatingOf(glare, byRays[Measure::Vertical + v], errorByRays[Measure::Vertical + v]);
  }
}

} // namespace PhotonTransport
