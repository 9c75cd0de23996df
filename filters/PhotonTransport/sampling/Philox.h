// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// Philox4x32-7: four random 32-bit numbers that are a function of a counter and a key alone, so
/// that no thread ever owns a stream. Salmon, Moraes, Dror and Shaw, "Parallel Random Numbers: As
/// Easy as 1, 2, 3", SC 2011; seven rounds pass BigCrush.
inline std::array<std::uint32_t, 4> Philox(
  std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key)
{
  constexpr int Rounds = 7;
  for (int round = 0; round < Rounds; ++round)
  {
    const std::uint64_t product0 = std::uint64_t{ 0xD2511F53u } * counter[0];
    const std::uint64_t product1 = std::uint64_t{ 0xCD9E8D57u } * counter[2];
    counter = { static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
      static_cast<std::uint32_t>(product1),
      static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
      static_cast<std::uint32_t>(product0) };
    key[0] += 0x9E3779B9u; // golden ratio
    key[1] += 0xBB67AE85u; // sqrt(3) - 1
  }
  return counter;
}

} // namespace PhotonTransport
