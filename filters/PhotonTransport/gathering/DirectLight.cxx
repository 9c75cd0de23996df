// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/DirectLight.h"

#include "PhotonTransport/sampling/ReceiverSample.h"
#include "PhotonTransport/sampling/Strata.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Samples of a piece that is hidden in part, over those of one that is not.
constexpr unsigned WholeByPart = 4;

constexpr unsigned LeastPairs = 2;

/// Strata of the hierarchy of pieces, over those of one piece.
constexpr unsigned StrataOfMany = 4;

} // namespace

/// What is known of a receiver while its light is summed up.
struct DirectLight::Task
{
  const Receiver& receiver;
  glm::dvec3 point;
  std::uint32_t seed;
  std::uint64_t index;
  unsigned samples;
  std::uint32_t block = 0; ///< Of the random numbers, the next one.
};

struct DirectLight::Outline
{
  bool isAlike; ///< All of it is seen, or none.
  bool mostIsSeen;
};

/// Adds an estimate from two independent samples in each of `pairs` strata. The variance of a
/// stratum's mean is a quarter of its samples' squared difference, on average.
/// @param draw Gives the sample of a number in [0, 1). @param stopped Adds what is stopped on
/// its way, as a negative number, in place of what arrives.
template <class Draw>
void DirectLight::AddPairs(
  Task& task, unsigned pairs, bool stopped, const Draw& draw, DirectResult& result) const
{
  constexpr unsigned Together = Visibility::Most / 2;
  std::array<std::optional<LightSample>, Visibility::Most> samples;
  std::array<Colour, Visibility::Most> transmittances;
  const double share = 1.0 / pairs;
  for (unsigned first = 0; first < pairs; first += Together)
  {
    const unsigned count = std::min(pairs - first, Together);
    for (unsigned pair = 0; pair < count; ++pair)
    {
      const std::array<std::uint32_t, 4> bits =
        ReceiverRandom(task.seed, ReceiverStream::DirectLight, task.index, task.block++);
      for (unsigned i = 0; i < 2; ++i)
      {
        samples[2 * pair + i] =
          draw(PlaceInInterval(first + pair, UnitDouble(bits[2 * i], bits[2 * i + 1]), pairs));
      }
    }
    this->Sampler.Follow(samples.data(), transmittances.data(), 2 * count);
    for (unsigned i = 0; i < 2 * count; i += 2)
    {
      double difference = 0.0;
      for (unsigned k = i; k < i + 2; ++k)
      {
        if (samples[k])
        {
          const Colour arrives = transmittances[k] - Colour(stopped ? 1.0f : 0.0f);
          const Colour light = samples[k]->light * arrives;
          result.ofLamp[samples[k]->lamp] += static_cast<float>(0.5 * share) * light;
          difference += k == i ? SumOfChannels(light) : -SumOfChannels(light);
        }
      }
      result.variance += 0.25 * share * share * difference * difference;
      if (task.receiver.IsInFreeSpace())
      {
        this->Keep(samples[i], transmittances[i], 0.5 * share, result);
        this->Keep(samples[i + 1], transmittances[i + 1], 0.5 * share, result);
      }
    }
  }
}

/// Keeps what a sample of a pair adds to the light, nothing included.
/// @param share By which it counts.
void DirectLight::Keep(const std::optional<LightSample>& sample, const Colour& transmittance,
  double share, DirectResult& result) const
{
  if (!sample)
  {
    result.arrived.push_back({ glm::vec3(0.0f, 0.0f, 1.0f), 1.0f, 0, true, 0.0, 0.0 });
    return;
  }
  const Incidence& way = sample->ray.light;
  const double whole = SumOfChannels(sample->light);
  const double light = SumOfChannels(sample->light * transmittance);
  const LightPiece& piece = *sample->piece;
  const double luminance = whole > 0.0 ? piece.bounds.flux * this->Sampler.PerSceneArea() *
      this->Sampler.Pieces().LuminancePerLumen(piece, way) * (light / whole)
                                       : 0.0;
  result.arrived.push_back(
    { way.towards, way.distance, sample->lamp, true, share * light, luminance });
}

/// All of which one ray tells everything.
void DirectLight::AddPointLike(const Task& task, DirectResult& result) const
{
  std::array<std::optional<LightSample>, Visibility::Most> samples;
  std::array<Colour, Visibility::Most> transmittances;
  std::size_t count = 0;
  const auto trace = [&]
  {
    this->Sampler.Follow(samples.data(), transmittances.data(), count);
    for (std::size_t i = 0; i < count; ++i)
    {
      result.ofLamp[samples[i]->lamp] += samples[i]->light * transmittances[i];
      if (task.receiver.IsInFreeSpace())
      {
        this->Keep(samples[i], transmittances[i], 1.0, result);
        result.arrived.back().paired = false;
      }
    }
    count = 0;
  };
  const auto add = [&](const LightPiece& piece)
  {
    samples[count] = this->Sampler.Of(task.receiver, piece, glm::vec2(0.5f));
    count += samples[count] ? 1 : 0;
    if (count == samples.size())
    {
      trace();
    }
  };
  const LightPieces& pieces = this->Sampler.Pieces();
  std::for_each(pieces.FromAfar().begin(), pieces.FromAfar().end(), add);
  if (pieces.Near().size() <= MostApart)
  {
    for (const LightPiece& piece : pieces.Near())
    {
      if (piece.numbers == PlaceNumbers::None)
      {
        add(piece);
      }
    }
  }
  trace();
}

/// What rays to the outline of a piece find. What hides a part of a piece mostly reaches over its
/// outline. These rays serve for decisions alone: they are the same for all seeds, so what they
/// decide leaves estimates without bias.
DirectLight::Outline DirectLight::LookAtOutline(const Task& task, const LightPiece& piece) const
{
  constexpr float Low = 1.0f / 64, High = 1.0f - Low; // clear of a rim around the lamp
  static constexpr std::array<glm::vec2, 8> Places{ glm::vec2(Low, Low), { 0.5f, Low },
    { High, Low }, { High, 0.5f }, { High, High }, { 0.5f, High }, { Low, High }, { Low, 0.5f } };
  std::array<std::optional<LightSample>, Places.size()> samples;
  std::array<Colour, Places.size()> transmittances;
  for (std::size_t i = 0; i < Places.size(); ++i)
  {
    samples[i] = this->Sampler.Of(task.receiver, piece, Places[i]);
  }
  this->Sampler.Follow(samples.data(), transmittances.data(), Places.size());
  double least = std::numeric_limits<double>::infinity(), most = 0.0, sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < Places.size(); ++i)
  {
    if (samples[i])
    {
      const double transmittance = SumOfChannels(transmittances[i]) / 3.0;
      least = std::min(least, transmittance);
      most = std::max(most, transmittance);
      sum += transmittance;
      ++count;
    }
  }
  return { !(most - least > 0.1 * most), sum > 0.5 * static_cast<double>(count) };
}

/// Few samples do where a piece is seen as a whole or not at all. Where most of it is seen they
/// tell what is missing from its light, which is known in a closed form: nothing, if all of it is
/// seen.
void DirectLight::AddPiece(Task& task, const LightPiece& piece, DirectResult& result) const
{
  const glm::dvec3 normal(task.receiver.normal);
  if (!(Brightness(piece.bounds, task.point, normal) > 0.0))
  {
    return;
  }
  const Outline outline = this->LookAtOutline(task, piece);
  const auto whole = outline.mostIsSeen && !task.receiver.IsInFreeSpace()
    ? this->Sampler.Pieces().Unobstructed(piece, task.point, normal)
    : std::nullopt;
  if (whole)
  {
    const double lux = piece.bounds.flux * *whole * this->Sampler.PerSceneArea();
    result.ofLamp[piece.lamp] += static_cast<float>(lux) * piece.shares;
  }
  const bool few = outline.isAlike && (whole || !outline.mostIsSeen);
  const unsigned pairs = task.samples / 2 / (few ? WholeByPart : 1u);
  this->AddPairs(
    task, std::max(LeastPairs, pairs), whole.has_value(),
    [&](double number) { return this->Sampler.Of(task.receiver, piece, PlaceOf(piece, number)); },
    result);
}

void DirectLight::At(const Receiver& receiver, unsigned samples, std::uint32_t seed,
  std::uint64_t index, DirectResult& result) const
{
  result.ofLamp.assign(this->Lamps(), Colour(0.0f));
  result.variance = 0.0;
  result.arrived.clear();
  if (receiver.starts.empty())
  {
    return;
  }
  Task task{ receiver, receiver.Middle(), seed, index, samples };
  this->AddPointLike(task, result);
  if (this->Sampler.Pieces().Near().size() > MostApart)
  {
    const LightTree::Cut cut =
      this->Sampler.Tree().CutAt(task.point, glm::dvec3(receiver.normal), LightTree::Cut::Most);
    this->AddPairs(
      task, StrataOfMany * std::max(LeastPairs, samples / 2), false,
      [&](double number) { return this->Sampler.OfMany(task.receiver, cut, number); }, result);
    return;
  }
  for (const LightPiece& piece : this->Sampler.Pieces().Near())
  {
    if (piece.numbers != PlaceNumbers::None)
    {
      this->AddPiece(task, piece, result);
    }
  }
}

Colour DirectLight::SkyRadiance(const glm::vec3& towards,
  const std::function<void(std::uint32_t lamp, const Colour& radiance)>& ofLamp) const
{
  Colour sum(0.0f);
  for (const std::uint32_t lamp : this->Sampler.Pieces().Skies())
  {
    const Emitter& source = this->Sampler.Pieces().Source();
    const double perLumen = this->Sampler.Pieces().SkyPerLumen(lamp, towards);
    const Colour radiance =
      static_cast<float>(source.Flux(lamp) * perLumen * this->Sampler.PerSceneArea()) *
      source.ChannelShares(lamp);
    sum += radiance;
    if (ofLamp)
    {
      ofLamp(lamp, radiance);
    }
  }
  return sum;
}

} // namespace PhotonTransport
