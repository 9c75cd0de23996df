// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <string>
#include <vector>

/// Something that is known of a map: a weighted sum of its illuminances.
struct Quantity
{
  double exact;
  std::vector<double> weights; ///< [vertex]
  bool indirectOnly = false;
};

/// A case of the table in Testing/README.md.
struct ValidationCase
{
  std::string name; ///< "5.2 point lamp": CIE 171:2006's number, if it has one.
  PhotonTransport::Surface surface;
  PhotonTransport::Lighting lighting;
  std::vector<Quantity> quantities;
  double photons = 4e6; ///< Of all runs together, the first time.
  PhotonTransport::TraceSettings settings{};
  /// The run is not told of openings to the sky.
  bool withoutOpenings = false;
};

/// Traces the case in 32 independent runs and expects each quantity within 3 standard errors of
/// what is exact, a standard error of at most 0.5 % of it, and all photons accounted for. Records
/// the case for the table.
///
/// By chance a correct tracer has a quantity beyond 3 standard errors in 0.5 % of all draws
/// (Student's t, 31 degrees of freedom), so about one of the hundreds here will be. The case is
/// then traced again, with other numbers and four times the photons, and that must be within: a
/// correct tracer fails a quantity with a chance of 3e-5, the more photons only show a wrong one
/// the better.
void ExpectExact(const ValidationCase& known);

/// Weights A_v g(x_v) over the points for which `counts` holds: for a flat part and a linear g the
/// quantity is the integral of g E over the part, as hat functions add up to linear functions.
std::vector<double> IntegralWeights(const PhotonTransport::Surface& surface,
  const std::vector<bool>& counts, const std::vector<double>& g);

/// Weight 1 for one point.
std::vector<double> PointWeights(const PhotonTransport::Surface& surface, std::size_t point);
