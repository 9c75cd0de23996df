// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The standard error of a part of the light of a vertex, as of one colour or one lamp, lx. Photons
/// bring it that carry nothing else.
///
/// Each photon is of one part with all its hits, whichever part that is. Had photons nothing to do
/// with each other, they would be Poisson processes, of which each has the share of the variance
/// that it has of the light. A sequence that spreads photons evenly makes the sum of all parts less
/// noisy than that, but not the choice between parts. So the variance of the whole counts, but at
/// least that of as many hits that are spread over facets (FewHits: 1.5 of the square by the number
/// of hits). One hit more counts than the part has, since a part without a hit may have light too.
/// @param whole The light, lx. @param error Its standard error, lx. @param hits That brought it.
/// @param part lx, [0, whole].
inline double PartError(double whole, double error, std::uint64_t hits, double part)
{
  if (hits == 0 || !(whole > 0.0))
  {
    return error;
  }
  constexpr double OfHit = 1.5;
  const auto n = static_cast<double>(hits);
  const double variance = std::max(error * error, OfHit * whole * whole / n);
  return std::sqrt(std::min(1.0, part / whole + 1.0 / n) * variance);
}

/// The standard errors of parts. @param map Whose hits tell of all light. @param partOf Gives the
/// part of a vertex, lx.
template <typename PartOf>
std::vector<double> PartErrors(const IlluminationMap& map, const PartOf& partOf)
{
  std::vector<double> errors;
  errors.reserve(map.direct.size());
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    errors.push_back(PartError(
      map.direct[v] + map.indirect[v], map.standardError[v], map.photonHits[v], partOf(v)));
  }
  return errors;
}

} // namespace PhotonTransport
