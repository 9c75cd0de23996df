// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LightPieces.h"
#include "PhotonTransport/gathering/LightTree.h"
#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/gathering/Visibility.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace PhotonTransport
{

/// Light of one place of a lamp, if nothing stands between.
struct LightSample
{
  ShadowRay ray;
  std::uint32_t lamp;
  Colour light;   ///< by channel, an estimate of all that is sampled.
  bool reachable; ///< Whether a ray can start in that direction.
  const LightPiece* piece;
};

/// The parts of channels are luminous, so that their sum is lx.
inline double SumOfChannels(const Colour& light)
{
  return double{ light.x } + light.y + light.z;
}

/// Samples of lamps at receivers, and what reaches the receivers of them.
class LightSampler
{
public:
  /// All arguments must outlive this. See DirectLight.
  LightSampler(const Scene& scene, const Emitter& emitter, const FacetRoulettes& materials,
    ScatteringSet switchedOn, double luxPerUnit);
  LightSampler(const LightSampler&) = delete; // its hierarchy refers to its pieces
  LightSampler& operator=(const LightSampler&) = delete;

  const LightPieces& Pieces() const { return this->AllPieces; }
  const LightTree& Tree() const { return this->NearTree; }
  /// Units of light that one lumen on one scene unit squared is.
  double PerSceneArea() const { return this->LightPerSceneArea; }

  /// Nothing if no light can arrive. @param place In the unit square. @param weight By which the
  /// light is multiplied.
  std::optional<LightSample> Of(const Receiver& receiver, const LightPiece& piece,
    const glm::vec2& place, double weight = 1.0) const;

  /// The same of all near pieces together. @param number In [0, 1).
  std::optional<LightSample> OfMany(
    const Receiver& receiver, const LightTree::Cut& cut, double number) const;

  /// The transmittances of the ways of samples, by channel: 0 where there is no sample.
  /// @param count Up to Visibility::Most.
  void Follow(
    const std::optional<LightSample>* samples, Colour* transmittances, std::size_t count) const;

private:
  LightPieces AllPieces;
  LightTree NearTree;
  Visibility Ways;
  double LightPerSceneArea;
};

} // namespace PhotonTransport
