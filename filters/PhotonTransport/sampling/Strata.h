// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/PhotonSample.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// Stratified numbers: an interval or the unit square is divided into equal parts, and each part
/// gets one random place, so that estimates of a smooth integrand have less variance.

namespace PhotonTransport
{

/// The largest number below 1.
constexpr double BelowOne = 1.0 - 0x1p-53;

/// A number in [0, 1) with all the digits of a double.
inline double UnitDouble(std::uint32_t high, std::uint32_t low)
{
  return static_cast<double>(((std::uint64_t{ high } << 32) | low) >> 11) * 0x1p-53;
}

/// A place in one of so many equal intervals of [0, 1). @param place Within the interval, [0, 1).
inline double PlaceInInterval(unsigned interval, double place, unsigned intervals)
{
  return std::min(BelowOne, (interval + place) / intervals);
}

/// A place in one of side x side strata of the unit square; coordinates in [0, 1).
/// @param stratum Its index, below side x side. @param bits The first two are used.
inline glm::vec2 PlaceInStratum(
  const std::array<std::uint32_t, 4>& bits, std::size_t stratum, std::size_t side)
{
  const glm::vec2 place = (glm::vec2(stratum / side, stratum % side) +
                            glm::vec2(UnitFloat(bits[0]), UnitFloat(bits[1]))) /
    static_cast<float>(side);
  return glm::min(place, 1.0f - 0x1p-24f); // the sum may have rounded up to 1
}

} // namespace PhotonTransport
