// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/gathering/CellSides.h"
#include "PhotonTransport/gathering/GatherScene.h"
#include "PhotonTransport/gathering/GatherSequence.h"
#include "PhotonTransport/gathering/LinkTable.h"
#include "PhotonTransport/gathering/SharesOfSides.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Traces rays from sides of cells and keeps what they meet as links. Each replicate of a side has
/// its own rays, which start all over the cell, one in each stratum of a square of directions that
/// are distributed as the cosine. As many rays again go to openings. Sides that are black send no
/// light, so there are no links to them.
class LinkTracer
{
public:
  /// All must outlive it. @param most Strata along each side of the square; fewer are used where
  /// the links would not fit. @param met Gets all sides that rays meet.
  LinkTracer(const GatherScene& scene, const SharesOfSides& shares, const CellExitance& exitance,
    std::size_t most, SidesMet& met);

  /// The links of so many sides of a list. They are there twice for a while: no more than
  /// SidesOfSlice should be traced at a time.
  LinkTable Trace(
    const std::vector<std::uint32_t>& sides, std::size_t first, std::size_t number) const;
  static constexpr std::size_t SidesOfSlice = std::size_t{ 1 } << 13;

  /// Along each side of a square of strata, one ray in each: 16, 9 or 4 rays for each replicate of
  /// a side, so that the links of large scenes fit.
  static std::size_t StrataFor(std::size_t cells, std::size_t replicates);

private:
  struct Sink;
  struct Workspace;
  LinkTable Empty() const;
  void AddSide(std::uint32_t side, Workspace& work, LinkTable& table) const;
  void AddReplicate(
    std::uint32_t side, std::size_t replicate, Workspace& work, LinkTable& table) const;
  void AddRay(std::uint32_t side, std::uint32_t ray, const GatherSequence& sequence,
    Workspace& work, Sink& sink) const;
  void AddOpenings(const GatherSequence& sequence, Workspace& work, Sink& sink) const;

  const GatherScene& Gathered;
  const SharesOfSides& Shares;
  std::size_t Replicates, Lamps, Channels;
  SidesMet& Met;
  std::size_t Strata;
};

} // namespace PhotonTransport
