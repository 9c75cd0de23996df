// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/statistics/ExtremeValue.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// Facets between points that have values; in between these are linear.
struct SummarisedFacets
{
  std::vector<glm::uvec3> corners; ///< Places in NoisyValues.
  std::vector<double> areas;       ///< m^2, > 0.
  std::vector<double> reflectance; ///< Diffuse, [0, 1].

  double Area() const;
};

/// What lighting design wants to know of a surface or of a grid of points.
struct LightSummary
{
  std::size_t points = 0;
  double area = 0.0;     ///< m^2; 0 without facets.
  Estimate mean;         ///< lx, weighted by area; over the points where there are no facets.
  Estimate meanOfPoints; ///< lx
  Estimate minimum;      ///< lx, see ExtremeValue.
  Estimate maximum;      ///< lx
  Estimate uniformity;   ///< U0 = minimum / mean; 0 in the dark.
  Estimate diversity;    ///< Ud = minimum / maximum; 0 in the dark.
  /// The share of the area, or of the points where there are no facets, where values are at or
  /// above the target; [0, 1].
  Estimate shareAtTarget;
  Estimate flux;      ///< lm, on the facets.
  Estimate luminance; ///< cd/m^2: the mean of reflectance E / pi over the facets.
};

/// Summarises values by closed forms: on each facet they are linear.
///
/// Errors. With groups, that of a mean, a flux or a share is that of the jackknife: of the four
/// maps that lack one group each. It counts that the noise of points is correlated, and has three
/// degrees of freedom. Without groups, nothing tells how noise is correlated. The error is then the
/// largest that it can be: half the change from values that are all one standard error too low to
/// values that are all too high. Errors of quotients take their parts as independent.
///
/// @param noisy Values and standard errors finite and >= 0. @param target lx.
/// @param goOn See ExtremeValue.
LightSummary Summarise(const NoisyValues& noisy, const SummarisedFacets& facets, double target,
  const std::function<bool()>& goOn);

} // namespace PhotonTransport
