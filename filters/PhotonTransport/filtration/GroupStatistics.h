// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/SpectralFilter.h"
#include "PhotonTransport/statistics/GroupMeans.h"

#include <array>
#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// Independent estimates of one value of a map, in single precision.
using Group = std::array<float, Groups>;
/// A map of such values.
using GroupColumns = Columns<Groups>;

inline double Square(double x)
{
  return x * x;
}

inline double MeanOf(const Group& x)
{
  double sum = 0.0;
  for (const float value : x)
  {
    sum += double{ value };
  }
  return sum / static_cast<double>(Groups);
}

/// Estimated covariance of the means of two groups.
inline double Covariance(const Group& x, const Group& y)
{
  const double meanX = MeanOf(x);
  const double meanY = MeanOf(y);
  double sum = 0.0;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    sum += (double{ x[g] } - meanX) * (double{ y[g] } - meanY);
  }
  return sum / static_cast<double>(Groups * (Groups - 1));
}

/// Estimated variance of the mean of a group.
inline double Variance(const Group& x)
{
  return Covariance(x, x);
}

inline Group Difference(const Group& x, const Group& y)
{
  Group difference;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    difference[g] = x[g] - y[g];
  }
  return difference;
}

} // namespace PhotonTransport
