// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/GroupStatistics.h"

#include <vector>

namespace PhotonTransport
{

/// The noise at each vertex by Poisson's law, from the illuminance that one photon makes there.
/// Group means have three degrees of freedom: they tell little of that scale, and nothing where no
/// photon came.
class PhotonNoise
{
public:
  /// @param lumens [patch] What a photon brings to the facet that it hits, in units of area times
  /// lx.
  PhotonNoise(const SmoothingGraph& graph, const std::vector<double>& lumens);

  /// q = lumens / A: one photon, counted for one vertex alone, lx. 0 for a vertex without an area.
  double OnePhoton(std::size_t v) const { return this->Photon[v]; }

  /// Variance (lx^2) of a value that is so many lx in truth. A photon counts for the three vertices
  /// of its facet by its place there: on average a third, by weights whose square is a sixth of it
  /// on average. A value E of A E / (lumens / 3) photons has the variance E lumens / (2 A).
  double Variance(std::size_t v, double value) const { return 0.5 * this->OnePhoton(v) * value; }

private:
  std::vector<float> Photon;
};

/// [patch] Lumens a photon from the photons counted on the facets around the vertices. Each counts
/// for three vertices, while its light is shared among them. All patches have the mean of the whole
/// map, but for those whose own is more than twice as large or small: there photons start with
/// another flux, such as those that come in through openings.
std::vector<double> LumensPerPhoton(const SmoothingGraph& graph,
  const std::vector<double>& illuminance, const std::vector<double>& hits);

/// The same where the photons were not counted, from the noise: sum(A^2 var X) = lumens / 2 sum(A
/// X) where Poisson's law holds. All patches have the same.
std::vector<double> LumensPerPhoton(const SmoothingGraph& graph, const GroupColumns& map);

} // namespace PhotonTransport
