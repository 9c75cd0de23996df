// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
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

  static IlluminationMap WithoutLight(std::size_t vertices)
  {
    const std::vector<double> dark(vertices, 0.0);
    return { dark, dark, {}, dark, std::vector<std::uint64_t>(vertices, 0) };
  }

  /// All light of a vertex, or of each.
  double Total(std::size_t vertex) const { return this->direct[vertex] + this->indirect[vertex]; }
  std::vector<double> Totals() const
  {
    std::vector<double> all(this->direct.size());
    std::transform(
      this->direct.begin(), this->direct.end(), this->indirect.begin(), all.begin(), std::plus<>());
    return all;
  }
};

} // namespace PhotonTransport
