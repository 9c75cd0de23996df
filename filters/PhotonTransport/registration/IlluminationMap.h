// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The illumination map of one side: a value a vertex, 0 at a vertex without a facet.
struct IlluminationMap
{
  std::vector<double> direct;            ///< Straight from the lamp, lx.
  std::vector<double> indirect;          ///< After at least one reflection, lx.
  std::vector<double> standardError;     ///< Of direct + indirect, lx: noise, not facet size.
  std::vector<std::uint64_t> photonHits; ///< On this side of the facets around the vertex.
};

} // namespace PhotonTransport
