// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// A side of a cell, as one index. The two sides of a cell follow each other, the front first.
inline std::size_t SideIndex(std::uint32_t cell, bool front)
{
  return std::size_t{ cell } * 2 + (front ? 0 : 1);
}
inline std::uint32_t CellOf(std::uint32_t side)
{
  return side / 2;
}
inline bool IsFront(std::uint32_t side)
{
  return side % 2 == 0;
}
inline std::uint32_t OtherSide(std::uint32_t side)
{
  return side ^ 1u;
}

constexpr std::uint32_t NoSide = 0xffffffffu;

} // namespace PhotonTransport
