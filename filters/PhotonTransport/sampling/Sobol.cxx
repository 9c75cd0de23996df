// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sampling/Sobol.h"

namespace PhotonTransport
{
namespace
{

/// Primitive polynomial (degree, inner coefficients) and first direction integers of a dimension.
struct SobolGenerator
{
  unsigned degree;
  unsigned coefficients;
  std::array<std::uint32_t, 5> initial;
};

/// Joe and Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J.
/// Sci. Comput. 30, 2008: dimensions 2 to 8 of their table new-joe-kuo-6.
constexpr std::array<SobolGenerator, SobolDimensions - 1> Generators = { {
  { 1, 0, { 1 } },
  { 2, 1, { 1, 3 } },
  { 3, 1, { 1, 3, 1 } },
  { 3, 2, { 1, 1, 1 } },
  { 4, 1, { 1, 1, 3, 3 } },
  { 4, 4, { 1, 3, 5, 13 } },
  { 5, 2, { 1, 1, 5, 5, 17 } },
} };

constexpr unsigned Bits = 32;

using DirectionTable = std::array<SobolPoint, Bits>;

constexpr DirectionTable MakeDirections()
{
  DirectionTable table{};
  for (unsigned bit = 0; bit < Bits; ++bit)
  {
    table[bit][0] = 1u << bit; // van der Corput, reversed
  }
  for (unsigned dimension = 1; dimension < SobolDimensions; ++dimension)
  {
    const SobolGenerator& g = Generators[dimension - 1];
    std::array<std::uint32_t, Bits> direction{};
    for (unsigned bit = 0; bit < Bits; ++bit)
    {
      if (bit < g.degree)
      {
        direction[bit] = g.initial[bit] << (Bits - 1 - bit);
        continue;
      }
      // Bratley and Fox 1988, equation (2).
      direction[bit] = direction[bit - g.degree] ^ (direction[bit - g.degree] >> g.degree);
      for (unsigned k = 1; k < g.degree; ++k)
      {
        if ((g.coefficients >> (g.degree - 1 - k)) & 1u)
        {
          direction[bit] ^= direction[bit - k];
        }
      }
    }
    for (unsigned bit = 0; bit < Bits; ++bit)
    {
      for (unsigned digit = 0; digit < Bits; ++digit)
      {
        table[bit][dimension] |= ((direction[bit] >> (Bits - 1 - digit)) & 1u) << digit;
      }
    }
  }
  return table;
}

void ExclusiveOr(SobolPoint& point, const SobolPoint& row)
{
  for (unsigned dimension = 0; dimension < SobolDimensions; ++dimension)
  {
    point[dimension] ^= row[dimension];
  }
}

} // namespace

alignas(32) constexpr DirectionTable SobolDirections = MakeDirections();

SobolPoint SobolPointAt(std::uint32_t index)
{
  SobolPoint point{};
  const std::uint32_t gray = index ^ (index >> 1);
  for (unsigned bit = 0; bit < Bits; ++bit)
  {
    if ((gray >> bit) & 1u)
    {
      ExclusiveOr(point, SobolDirections[bit]);
    }
  }
  return point;
}

} // namespace PhotonTransport
