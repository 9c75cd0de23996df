// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/ReceiverSample.h"
#include "PhotonTransport/sampling/Strata.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// The random numbers of the rays of one receiver, as a function of the seed, the receiver, the ray
/// and how often the ray has been scattered (its order).
struct GatherSequence
{
  ReceiverStream stream;
  std::uint64_t receiver; ///< Index.

  static constexpr std::uint32_t OfLamps = 0x80000000u;  ///< Numbers for places of lamps.
  static constexpr std::uint32_t OfBranch = 0x40000000u; ///< For rays that have branched off.
  /// In place of an order: the numbers for the start and the direction of a ray.
  static constexpr std::uint32_t AtStart = 0x3fffu;

  /// @param ray Below 2^16. @param purpose 0, OfLamps or OfBranch.
  std::array<std::uint32_t, 4> Numbers(
    std::uint32_t seed, std::uint32_t ray, std::uint32_t order, std::uint32_t purpose = 0) const
  {
    constexpr std::uint32_t MostOrders = 0x3fffu;
    return ReceiverRandom(
      seed, this->stream, this->receiver, purpose | ((order & MostOrders) << 16) | ray);
  }
  /// A place in one of side x side strata of the unit square, where the direction of a ray comes
  /// from.
  glm::vec2 PlaceOf(std::uint32_t seed, std::size_t stratum, std::size_t side) const
  {
    constexpr std::uint32_t OfPlaces = 0x40000000u;
    return PlaceInStratum(ReceiverRandom(seed, this->stream, this->receiver,
                            OfPlaces | static_cast<std::uint32_t>(stratum)),
      stratum, side);
  }
};

/// One number in [0, 1) with all digits that a choice among many lamps and a place on it need.
inline double LampNumber(const std::array<std::uint32_t, 4>& bits)
{
  return std::min(BelowOne, bits[0] * 0x1p-32 + bits[1] * 0x1p-64);
}

} // namespace PhotonTransport
