// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeasuredMap.h"
#include "ReferenceFile.h"

#include <vector>

/// How far maps of one scene are from the light at single points. The noise of the reference is
/// taken out of mean squares, and added to what is told where that is compared.
struct MapErrors
{
  std::size_t points = 0; ///< That were compared.
  double rms = 0.0;       ///< % of the reference's mean.
  double bias = 0.0;      ///< Mean signed error, % of the reference's mean.
  double told = 0.0;      ///< RMS of the standard errors, % of the reference's mean.
  double medianRelative = 0.0, rmsRelative = 0.0; ///< Of error over reference, %.
  double rmsOfUnits = 0.0;                        ///< Error over what is told; 1 is right.
  double within2 = 0.0, within3 = 0.0;            ///< % of points within 2 and 3 of what is told.
};

/// The same for a reference itself: what it tells of its own errors.
struct ReferenceQuality
{
  double mean = 0.0;               ///< lx
  double rms = 0.0;                ///< % of the mean.
  double median = 0.0, most = 0.0; ///< Relative, %.
  double relativeRms = 0.0;        ///< %
};

/// Points that a comparison uses: those known to 10 %, and, if asked for, over 1 lx.
std::vector<std::size_t> ComparablePoints(const StoredReference& reference, bool onlyLit);

/// Those of the points that are not on a border, where facets end: a map's values are means over
/// the facets around, and at a border these lie on one side.
std::vector<std::size_t> InnerPoints(const PhotonTransport::Surface& surface,
  const StoredReference& reference, const std::vector<std::size_t>& points);

ReferenceQuality QualityOf(
  const StoredReference& reference, const std::vector<std::size_t>& points);

/// Over all maps.
MapErrors ErrorsOf(const std::vector<MeasuredMap>& maps, const StoredReference& reference,
  const std::vector<std::size_t>& points);
