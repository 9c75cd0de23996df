// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/statistics/GroupMeans.h"

#include <functional>
#include <vector>

namespace PhotonTransport
{

/// A number and its standard error.
struct Estimate
{
  double value = 0.0;
  double error = 0.0;
};

/// Values at points, lx, and what is known of their noise.
struct NoisyValues
{
  std::vector<double> values;
  std::vector<double> standardErrors; ///< [point] Or empty.
  std::vector<GroupValues> groups;    ///< [point] Or empty.

  bool KnowNoise() const { return !this->standardErrors.empty() || !this->groups.empty(); }
};

enum class Extreme
{
  Minimum,
  Maximum
};

/// The least or greatest of noisy values.
///
/// The least of n values that are known to s each is too low by up to about s sqrt(2 ln n), since
/// what is found is the point with the greatest negative noise. Here one half of the samples finds
/// the point and the other half tells its value, so that the noise of the first is not in it.
/// Halves are pairs of the four groups where there are groups. Otherwise noise is added: for normal
/// noise of a known standard error s and a normal number w, the values y + s w and y - s w are
/// independent, as two halves of the samples would be (Tian and Taylor, "Selective inference with a
/// randomized response", 2018). The result is the mean over all pairs, or over 64 draws of w that
/// are functions of the point alone.
///
/// The half that finds the point takes each value as five standard errors higher than it is, which
/// are 3.5 of that half. Where all points are known alike this changes nothing. Otherwise those
/// that are known worst would be found, and the result would be their noise.
///
/// What is found is at least the true minimum, on average, as half the samples may find another
/// point. The plain minimum is at most the true one. Half the difference of the two counts in the
/// error, beside the standard error at the points that were found. Without knowledge of the noise
/// the result is the plain minimum and its error is 0. All of this holds for the maximum likewise.
///
/// @param noisy At least one value, all >= 0; so is the result. @param goOn Called now and then;
/// the result means nothing once it has returned false.
Estimate ExtremeValue(const NoisyValues& noisy, Extreme which, const std::function<bool()>& goOn);

} // namespace PhotonTransport
