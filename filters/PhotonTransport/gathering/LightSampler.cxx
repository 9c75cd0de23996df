// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LightSampler.h"

#include <glm/geometric.hpp>

#include <array>

namespace PhotonTransport
{

LightSampler::LightSampler(const Scene& scene, const Emitter& emitter,
  const FacetRoulettes& materials, ScatteringSet switchedOn, double luxPerUnit)
  : AllPieces(emitter)
  , NearTree(this->AllPieces)
  , Ways(scene, materials, switchedOn)
  , LightPerSceneArea(1.0 / (scene.SquareMetresPerSceneArea() * luxPerUnit))
{
}

std::optional<LightSample> LightSampler::Of(
  const Receiver& receiver, const LightPiece& piece, const glm::vec2& place, double weight) const
{
  const glm::dvec3 point =
    piece.numbers == PlaceNumbers::None ? glm::dvec3(receiver.position) : receiver.Middle();
  const Incidence light = this->AllPieces.Arriving(piece, point, place);
  if (!(light.perLumen > 0.0))
  {
    return std::nullopt;
  }
  const double counts = receiver.Counts(light.towards);
  if (!(counts > 0.0))
  {
    return std::nullopt;
  }
  const glm::vec3* start = receiver.StartTowards(light.towards);
  const double lux = weight * piece.bounds.flux * light.perLumen * counts * this->LightPerSceneArea;
  return LightSample{ { start ? *start : glm::vec3(0.0f), light }, piece.lamp,
    static_cast<float>(lux) * piece.shares, start != nullptr, &piece };
}

std::optional<LightSample> LightSampler::OfMany(
  const Receiver& receiver, const LightTree::Cut& cut, double number) const
{
  const LightTree::Choice choice = this->NearTree.Choose(cut, number);
  if (!(choice.probability > 0.0))
  {
    return std::nullopt;
  }
  const LightPiece& piece = this->AllPieces.Near()[choice.piece];
  return this->Of(receiver, piece, PlaceOf(piece, choice.number), 1.0 / choice.probability);
}

void LightSampler::Follow(
  const std::optional<LightSample>* samples, Colour* transmittances, std::size_t count) const
{
  std::array<ShadowRay, Visibility::Most> rays;
  std::array<Colour, Visibility::Most> found;
  std::size_t wanted = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (samples[i] && samples[i]->reachable)
    {
      rays[wanted++] = samples[i]->ray;
    }
  }
  this->Ways.Follow(rays.data(), found.data(), wanted);
  wanted = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    transmittances[i] = samples[i] && samples[i]->reachable ? found[wanted++] : Colour(0.0f);
  }
}

} // namespace PhotonTransport
