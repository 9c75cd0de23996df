// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/LightSamples.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// A difference by so many standard errors is no noise: one of 16 000 edges has it by chance.
constexpr double Significant = 4.0;

double MissOn(const GatheredMap& side, std::size_t a, std::size_t middle, std::size_t b,
  double tolerance, double darkest)
{
  const auto light = [&](std::size_t i) { return side.direct[i] + side.gathered[i]; };
  const auto variance = [&](std::size_t i) { return std::pow(side.standardError[i], 2.0); };
  const double miss = std::fabs(light(middle) - 0.5 * (light(a) + light(b)));
  const double noise = std::sqrt(variance(middle) + 0.25 * (variance(a) + variance(b)));
  const double mean = (light(a) + light(middle) + light(b)) / 3.0;
  return miss > tolerance * std::max(mean, darkest) && miss > Significant * noise ? miss : 0.0;
}

} // namespace

LightSamples::LightSamples(const GatheredMap& front, const GatheredMap& back)
  : Sides{ front, back }
  , Vertices(front.direct.size())
  , Lamps(front.ofLamps.size() / std::max<std::size_t>(1, front.direct.size()))
{
}

void LightSamples::Resize(std::size_t number)
{
  const bool colour = !this->Sides[0].channels.empty();
  const bool hasBack = this->HasBack();
  this->Sides[0].Resize(number, colour, this->Lamps);
  if (hasBack)
  {
    this->Sides[1].Resize(number, colour, this->Lamps);
  }
}

bool LightSamples::Add(std::size_t number,
  const std::function<void(std::size_t i, bool front, Receiver& receiver)>& make,
  const GatherPass& pass, const GatherPass::Report& report)
{
  const std::size_t first = this->Number();
  const ReceiverList receivers{ first, number,
    [&](std::uint64_t place, bool front, Receiver& receiver)
    { make(static_cast<std::size_t>(place) - first, front, receiver); } };
  const GatherPass::Report all = [&](std::uint64_t done)
  { return report(first - this->Vertices + done); };
  const bool hasBack = this->HasBack();
  this->Resize(first + number);
  bool goOn = true;
  for (int side = 0; goOn && side < (hasBack ? 2 : 1); ++side)
  {
    std::vector<std::uint8_t> done;
    goOn = pass.Receive(
      receivers, side == 0, report ? all : GatherPass::Report(), this->Sides[side], done);
  }
  if (!goOn)
  {
    this->Resize(first);
  }
  return goOn;
}

double LightSamples::Miss(
  std::size_t a, std::size_t middle, std::size_t b, double tolerance, const Floor& darkest) const
{
  const double onFront = MissOn(this->Sides[0], a, middle, b, tolerance, darkest.front);
  return this->HasBack()
    ? std::max(onFront, MissOn(this->Sides[1], a, middle, b, tolerance, darkest.back))
    : onFront;
}

GatheredMap LightSamples::Front(const std::vector<std::uint32_t>& samples) const
{
  return this->Chosen(this->Sides[0], samples);
}

GatheredMap LightSamples::Back(const std::vector<std::uint32_t>& samples) const
{
  return this->HasBack() ? this->Chosen(this->Sides[1], samples) : GatheredMap();
}

GatheredMap LightSamples::Chosen(
  const GatheredMap& side, const std::vector<std::uint32_t>& samples) const
{
  GatheredMap map;
  map.Resize(samples.size(), !side.channels.empty(), this->Lamps);
  for (std::size_t p = 0; p < samples.size(); ++p)
  {
    const std::size_t s = samples[p];
    map.direct[p] = side.direct[s];
    map.gathered[p] = side.gathered[s];
    map.standardError[p] = side.standardError[s];
    if (!map.channels.empty())
    {
      map.channels[p] = side.channels[s];
    }
    for (std::size_t lamp = 0; lamp < this->Lamps; ++lamp)
    {
      map.ofLamps[p * this->Lamps + lamp] = side.ofLamps[s * this->Lamps + lamp];
    }
  }
  return map;
}

} // namespace PhotonTransport
