// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How good a map is and what it has cost.
struct Accuracy
{
  std::uint64_t photons = 0;
  double seconds = 0.0; ///< Of tracing and of measuring the error.
  /// Area-weighted root mean square of the standard error over the area-weighted mean illuminance;
  /// the stop rule's measure. 1 in the dark.
  double relativeError = 0.0;
  /// Of standardError / illuminance over the vertices that light reached.
  double medianRelativeError = 0.0;
  double percentile95RelativeError = 0.0;
  double segmentsPerSecond = 0.0;
  /// What the run will have taken, counted from its start, when the target is reached; 0 without a
  /// target.
  double predictedPhotons = 0.0;
  double predictedSeconds = 0.0;
};

/// Fills in the three relative errors. @param areas [vertex] m^2.
void MeasureErrors(
  Accuracy& accuracy, const IlluminationMap& map, const std::vector<double>& areas);

/// Fills in the prediction for a target from how the error has fallen so far. @param earlier Rows
/// before this one, in order. @param target Relative error, > 0.
void PredictCost(Accuracy& accuracy, const std::vector<Accuracy>& earlier, double target);

} // namespace PhotonTransport
