// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// Dimensions of the Sobol sequence in use: four for the emission (position, direction), one for
/// the choice of the lamp and of the facet that shines, three for the first scattering (survival,
/// direction).
constexpr unsigned SobolDimensions = 8;

/// A point of the Sobol sequence, each coordinate with its bits *reversed* (first binary digit in
/// the lowest bit), as the scrambling below wants it.
using SobolPoint = std::array<std::uint32_t, SobolDimensions>;

/// Point number `index` in Gray code order. That order visits each block of 2^k points in another
/// order than the plain sequence does, and the next point costs one exclusive-or in each dimension.
SobolPoint SobolPointAt(std::uint32_t index);

/// Direction numbers by bit, then dimension, digits reversed: one row is one cache line half.
extern const std::array<SobolPoint, 32> SobolDirections;

/// What turns point number `index` into point number `index + 1` by exclusive-or.
inline const SobolPoint& SobolStep(std::uint32_t index)
{
  // Gray codes of neighbours differ in the lowest zero bit of the smaller. After the last of the
  // 2^32 points any row will do: the caller starts a new sequence.
  return SobolDirections[static_cast<unsigned>(__builtin_ctz(~index | 0x80000000u))];
}
inline void AdvanceSobolPoint(SobolPoint& point, std::uint32_t index)
{
  const SobolPoint& step = SobolStep(index);
  for (unsigned d = 0; d < SobolDimensions; ++d)
  {
    point[d] ^= step[d];
  }
}

/// Owen's nested uniform scrambling of one reversed coordinate; the result is an ordinary binary
/// fraction, digits in order. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020,
/// after Laine and Karras 2011, with the better mixing constants found by N. Vegdahl (2021).
/// @tparam Bits A number of 32 bits, or a vector of such. @param x The coordinate, and the result.
template <typename Bits>
[[gnu::always_inline]] inline void OwenScrambleInPlace(Bits& x, const Bits& seed)
{
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;

  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  x = (x >> 16) | (x << 16);
}
inline std::uint32_t OwenScramble(std::uint32_t reversed, std::uint32_t seed)
{
  OwenScrambleInPlace(reversed, seed);
  return reversed;
}

} // namespace PhotonTransport
