// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// How good a map is, or a part of it.
struct MapErrors
{
  /// Area-weighted root mean square of the error over the area-weighted mean illuminance. The error
  /// is the standard error, and where facets count the FacetError, too, the root of the sum of
  /// their squares. 1 in the dark.
  double relativeError = 0.0;
  /// The part of FacetError in relativeError; 0 where facets do not count.
  double relativeFacetError = 0.0;
  /// Of standardError / illuminance over the vertices that light reached.
  double medianRelativeError = 0.0;
  double percentile95RelativeError = 0.0;
};

/// How good a map is and what it has cost.
struct Accuracy : MapErrors
{
  std::uint64_t photons = 0;
  std::uint32_t gatherRays = 0; ///< For each vertex, about; 0 in Method::PhotonTracing.
  double seconds = 0.0;         ///< Of tracing, gathering and measuring the error.
  /// Of the region where accuracy counts; nothing if there is none, or if it was another one then.
  std::optional<MapErrors> region;
  double segmentsPerSecond = 0.0;
  /// What the run will have taken, counted from its start, when the target is reached; 0 without a
  /// target, infinite where facets are too large for it.
  double predictedPhotons = 0.0;
  double predictedSeconds = 0.0;

  /// What the stop rule goes by: the region, if there is one, or else the whole.
  const MapErrors& Targeted() const { return this->region ? *this->region : *this; }
};

/// @param areas [vertex] m^2. Vertices with 0 do not count. @param facetError [vertex] lx; empty
/// where facets do not count.
MapErrors MeasureErrors(const IlluminationMap& map, const std::vector<double>& areas,
  const std::vector<double>& facetError);

/// Whether more photons would not reach the target, because the facets' part of the error is larger
/// than it. That part is known once it is no less than the noise. @param target > 0.
bool FacetsAreTooLarge(const MapErrors& errors, double target);

/// Fills in the prediction for a target from how the error has fallen so far. @param earlier Rows
/// before this one, in order. @param target Relative error, > 0.
void PredictCost(Accuracy& accuracy, const std::vector<Accuracy>& earlier, double target);

} // namespace PhotonTransport
