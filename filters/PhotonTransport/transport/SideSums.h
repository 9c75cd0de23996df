// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationSums.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What replicates have summed up at the vertices on one side of the surface. Of each replicate
/// this is no more than its spread needs: 8 bytes a vertex in place of the 32 of VertexSums.
struct SideSums
{
  SideSums() = default;
  /// @param parts Direct light is kept in so many parts, that of replicate r in part r % parts.
  SideSums(std::size_t vertices, std::size_t replicates, std::size_t parts);
  static constexpr std::uint64_t BytesPerVertex(std::uint64_t replicates, std::uint64_t parts)
  {
    return (replicates + parts) * sizeof(FixedPoint) + sizeof(std::uint64_t);
  }

  /// Adds what a replicate has got, and clears it.
  void Add(std::size_t replicate, std::vector<VertexSums>& sums);

  std::size_t Vertices() const { return this->hits.size(); }
  /// Of all replicates.
  VertexSums Total(std::size_t vertex) const;

  std::vector<std::vector<FixedPoint>> weights; ///< [replicate][vertex] Of all light.
  std::vector<std::vector<FixedPoint>> direct;  ///< [part][vertex]
  std::vector<std::uint64_t> hits;              ///< [vertex] Of all replicates.
};

} // namespace PhotonTransport
