// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/Philox.h"

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// What draws numbers at receivers. The blocks of different users never are the same.
enum class ReceiverStream : std::uint32_t
{
  Probe = 0x50726f62u,       ///< Rays that find out where light comes from.
  Guided = 0x47756964u,      ///< Rays that go there.
  DirectLight = 0x4c616d70u, ///< Places of lamps.
  Openings = 0x4f70656eu,    ///< Rays through openings.
  Links = 0x4c696e6bu,       ///< Rays between cells.
  Surroundings = 0x536f6c69u ///< Rays that find out whether a point lies within a solid.
};

/// Block number `block` of the random numbers of a receiver: a function of these alone, so that no
/// thread ever owns a stream.
inline std::array<std::uint32_t, 4> ReceiverRandom(
  std::uint32_t seed, ReceiverStream stream, std::uint64_t receiver, std::uint32_t block)
{
  constexpr std::uint32_t SecondPass = 0x47617468u;
  return Philox({ static_cast<std::uint32_t>(receiver), static_cast<std::uint32_t>(receiver >> 32),
                  block, static_cast<std::uint32_t>(stream) },
    { seed, SecondPass });
}

} // namespace PhotonTransport
