// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The illumination map of one side: one value for each vertex, 0 at a vertex without a facet.
struct IlluminationMap
{
  std::vector<double> direct;   ///< Straight from the lamps or through thin panes, lx.
  std::vector<double> indirect; ///< All other light, lx.
  /// The part of `indirect` that only mirrors, gloss and glass have sent here, lx; empty unless it
  /// is kept apart.
  std::vector<double> caustic;
  std::vector<double> standardError;     ///< Of direct + indirect, lx: noise, not facet size.
  std::vector<std::uint64_t> photonHits; ///< On this side of the facets around the vertex.
};

} // namespace PhotonTransport
