// SPDX-License-Identifier: BSD-3-Clause
// The variance of a sum over rays, one in each stratum of a square. That within strata shows in the
// second differences of three strata in a row, (a - 2 b + c)^2 = 6 variances on average: light that
// rises evenly from stratum to stratum leaves none.
#pragma once

#include <algorithm>
#include <cstddef>

namespace PhotonTransport
{

/// Calls f(a, b, c) for each three strata that follow each other in a row or a column, by their
/// indices. @param side Strata along each side of the square.
template <class Function>
void ForEachThreeStrata(std::size_t side, const Function& f)
{
  for (std::size_t line = 0; line < side; ++line)
  {
    for (std::size_t i = 1; i + 1 < side; ++i)
    {
      f(line * side + i - 1, line * side + i, line * side + i + 1);
      f((i - 1) * side + line, i * side + line, (i + 1) * side + line);
    }
  }
}

/// The variance of the sum of all strata. @param squares The sum of the squared second differences.
/// Their two factors may be estimates whose errors are independent, which keeps these errors out of
/// the variance.
inline double VarianceOfStrata(std::size_t side, double squares)
{
  // Rows and columns together count each stratum 2 (side - 2) / side times.
  const auto strata = static_cast<double>(side);
  return std::max(0.0, squares / 6.0 * strata / (2.0 * (strata - 2.0)));
}

} // namespace PhotonTransport
