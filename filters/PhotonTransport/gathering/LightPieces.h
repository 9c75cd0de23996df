// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LightBounds.h"
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/lights/Incidence.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// A whole lamp, or one triangle of a surface that shines.
struct LightPiece
{
  std::uint32_t lamp;
  std::uint32_t part; ///< Which triangle of the lamp.
  PlaceNumbers numbers;
  Colour shares;      ///< Of the channels in its flux.
  LightBounds bounds; ///< With its flux. Unset from afar.
};

/// Where in the unit square one number in [0, 1) chooses a place of a piece, so that an interval
/// of numbers chooses a compact part of it.
inline glm::vec2 PlaceOf(const LightPiece& piece, double number)
{
  return piece.numbers == PlaceNumbers::Two ? PlaceInSquare(number)
                                            : glm::vec2(static_cast<float>(number), 0.0f);
}

/// All lamps but skies, piece by piece; those that have no flux are left out.
class LightPieces
{
public:
  /// @param emitter Must outlive this.
  explicit LightPieces(const Emitter& emitter);

  const std::vector<LightPiece>& Near() const { return this->NearOnes; }
  const std::vector<LightPiece>& FromAfar() const { return this->FarOnes; }
  const std::vector<std::uint32_t>& Skies() const { return this->SkyLamps; } ///< By lamp.

  /// Light of a place of a piece, for 1 lm of its flux. @param place In the unit square.
  Incidence Arriving(
    const LightPiece& piece, const glm::dvec3& point, const glm::vec2& place) const;

  /// Illuminance by all of a piece in a closed form, if there is one; see LampKind.h.
  std::optional<double> Unobstructed(
    const LightPiece& piece, const glm::dvec3& point, const glm::dvec3& normal) const;

  /// Luminance of a place of a piece as it is seen where its light arrives, for 1 lm of its flux:
  /// illuminance (Incidence::perLumen) per steradian. 0 for points, lines and light from afar,
  /// which have no area.
  double LuminancePerLumen(const LightPiece& piece, const Incidence& light) const;

  /// RadiancePerLumen of a lamp that is a sky; see LampKind.h.
  double SkyPerLumen(std::uint32_t lamp, const glm::vec3& towards) const;

  const Emitter& Source() const { return this->Lamps; }

private:
  const Emitter& Lamps;
  std::vector<LightPiece> NearOnes, FarOnes;
  std::vector<std::uint32_t> SkyLamps;
};

} // namespace PhotonTransport
