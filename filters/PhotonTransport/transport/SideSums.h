// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationSums.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What replicates have summed up at the vertices on one side of the surface, in the slots of
/// IlluminationSums. Of each replicate this is no more than its spread needs: 8 bytes a slot in
/// place of the 32 of VertexSums.
struct SideSums
{
  SideSums() = default;
  /// @param parts Direct light is kept in so many parts, that of replicate r in part r % parts.
  SideSums(
    std::size_t slots, std::size_t replicates, std::size_t parts, std::size_t lampsApart = 1);
  static constexpr std::uint64_t BytesPerSlot(std::uint64_t replicates, std::uint64_t parts)
  {
    return (replicates + parts) * sizeof(FixedPoint) + sizeof(std::uint64_t);
  }

  /// Adds what a replicate has got, and clears it.
  void Add(std::size_t replicate, std::vector<VertexSums>& sums);

  std::size_t Slots() const { return this->hits.size(); }
  std::size_t Vertices() const { return this->hits.size() / this->lamps; }
  /// Of all replicates.
  VertexSums Total(std::size_t slot) const;

  std::size_t lamps = 1;                        ///< That are kept apart.
  std::vector<std::vector<FixedPoint>> weights; ///< [replicate][slot] Of all light.
  std::vector<std::vector<FixedPoint>> direct;  ///< [part][slot]
  std::vector<std::uint64_t> hits;              ///< [slot] Of all replicates.
};

} // namespace PhotonTransport
