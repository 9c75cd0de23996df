// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

/// A map against what is known.
struct Comparison
{
  double squaredError =
    0.0; ///< Area-weighted mean of (E - exact)^2 over the largest exact, squared.
  double squaredNoise = 0.0; ///< The same of the standard error.
  double largestError = 0.0; ///< Over the largest exact.

  /// Root mean square error that noise does not explain.
  double Bias() const;
};

/// @param exact [vertex] lx; only vertices with `counts` (all, if empty) enter.
Comparison Compare(const PhotonTransport::Scene& scene, const std::vector<double>& map,
  const std::vector<double>& standardError, const std::vector<double>& exact,
  const std::vector<bool>& counts = {});

/// Illuminance at a point of a facet with unit normal, lx.
using Illuminance = std::function<double(const glm::dvec3& point, const glm::dvec3& normal)>;

/// What a vertex of a map of a flat surface estimates: the mean of E over its ring, weighted by the
/// barycentric coordinate, by a quadrature of 16^2 points a facet. In the data's units.
std::vector<double> RingMeans(
  const PhotonTransport::Surface& surface, const Illuminance& illuminance);

/// Direct + indirect, lx.
std::vector<double> Total(const PhotonTransport::IlluminationMap& map);

/// sum A E / sum A
double AreaMean(const PhotonTransport::Scene& scene, const std::vector<double>& map);
