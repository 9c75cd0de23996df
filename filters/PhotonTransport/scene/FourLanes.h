// SPDX-License-Identifier: BSD-3-Clause
// Four numbers side by side, which compilers turn into one instruction of any processor.
#pragma once

#include <cstdint>
#include <cstring>

namespace PhotonTransport
{

using Four = float __attribute__((vector_size(16)));
/// What comparisons of them yield: all bits where they hold, none where they do not.
using FourBits = std::int32_t __attribute__((vector_size(16)));

inline Four FourTimes(float number)
{
  return Four{ number, number, number, number };
}

inline Four Least(const Four& a, const Four& b)
{
  return a < b ? a : b;
}

inline Four Largest(const Four& a, const Four& b)
{
  return a < b ? b : a;
}

inline bool Any(const FourBits& bits)
{
  std::uint64_t halves[2];
  static_assert(sizeof halves == sizeof bits);
  std::memcpy(halves, &bits, sizeof bits);
  return (halves[0] | halves[1]) != 0;
}

} // namespace PhotonTransport
