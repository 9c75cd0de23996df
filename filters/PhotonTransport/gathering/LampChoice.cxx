// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LampChoice.h"

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/sampling/Strata.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <optional>

namespace PhotonTransport
{
namespace
{

/// Nodes of the hierarchy of near pieces among which a sample chooses.
constexpr std::size_t Nodes = 16;

/// With which probabilities one sample stands for the light of all lamps at a receiver: one for all
/// near pieces together, and one for each piece from afar. They are in proportion to about how
/// bright these are there, but for a tenth, which is spread evenly.
class LampChoice
{
public:
  /// @param nearBrightness Of all near pieces together, in the units of the samples.
  LampChoice(const LightSampler& sampler, const Receiver& receiver, double nearBrightness)
    : Near(nearBrightness)
    , Whole(nearBrightness)
    , Choices(nearBrightness > 0.0 ? 1 : 0)
  {
    for (const LightPiece& piece : sampler.Pieces().FromAfar())
    {
      const auto sample = sampler.Of(receiver, piece, glm::vec2(0.5f));
      this->Whole += sample ? SumOfChannels(sample->light) : 0.0;
      this->Choices += sample ? 1 : 0;
    }
  }

  double OfNear() const { return this->Of(this->Near); }
  double OfAfar(const std::optional<LightSample>& sample) const
  {
    return sample ? this->Of(SumOfChannels(sample->light)) : 0.0;
  }

private:
  double Of(double brightness) const
  {
    return brightness > 0.0 ? 0.9 * brightness / this->Whole + 0.1 / this->Choices : 0.0;
  }

  double Near;
  double Whole;
  unsigned Choices;
};

/// @param probability With which the sample was chosen.
Colour Arriving(const LightSampler& sampler, const std::optional<LightSample>& sample,
  double probability, std::uint32_t& lamp)
{
  if (!sample)
  {
    return Colour(0.0f);
  }
  lamp = sample->lamp;
  Colour transmittance;
  sampler.Follow(&sample, &transmittance, 1);
  return static_cast<float>(1.0 / probability) * sample->light * transmittance;
}

} // namespace

Colour SampleOfAllLamps(
  const LightSampler& sampler, const Receiver& receiver, double number, std::uint32_t& lamp)
{
  lamp = 0;
  if (receiver.starts.empty())
  {
    return Colour(0.0f);
  }
  const LightTree::Cut cut =
    sampler.Tree().CutAt(receiver.Middle(), glm::dvec3(receiver.normal), Nodes);
  const LampChoice choice(sampler, receiver, cut.Brightness() * sampler.PerSceneArea() / Pi);
  double left = number;
  for (const LightPiece& piece : sampler.Pieces().FromAfar())
  {
    const auto sample = sampler.Of(receiver, piece, glm::vec2(0.5f));
    const double chance = choice.OfAfar(sample);
    if (left < chance)
    {
      return Arriving(sampler, sample, chance, lamp);
    }
    left -= chance;
  }
  const double chance = choice.OfNear();
  return chance > 0.0
    ? Arriving(sampler, sampler.OfMany(receiver, cut, std::clamp(left / chance, 0.0, BelowOne)),
        chance, lamp)
    : Colour(0.0f);
}

} // namespace PhotonTransport
