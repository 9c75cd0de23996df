// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/gathering/GatherScene.h"
#include "PhotonTransport/gathering/GatherSequence.h"
#include "PhotonTransport/gathering/LinkTable.h"
#include "PhotonTransport/gathering/PhotonExitance.h"
#include "PhotonTransport/gathering/SharesOfSides.h"
#include "PhotonTransport/gathering/Viewers.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// A first pass for light that hardly any photon brings, such as daylight that enters a room by a
/// window: the sides of cells that rays see gather light from each other. Each side traces some
/// rays once and keeps the links to the sides that they meet (LinkTracer); what all sides get from
/// each other is then the solution of linear equations (LinkSolver).
class CellLinks
{
public:
  /// Finds the sides that the viewers see by a few rays each. The scene and the effects must
  /// outlive it.
  /// @param gatherRays That a receiver will gather by: the more they are, the more each side
  /// traces.
  CellLinks(const GatherScene& scene, const Viewers& viewers, const Effects& effects,
    std::uint32_t gatherRays);

  /// Whether photons have hardly lit many of the sides that receivers see.
  bool PhotonsAreFew(const PhotonCounts& counts) const;

  /// Is told how many bytes the links take as they become more, and may throw.
  using Watch = std::function<void(std::uint64_t bytes)>;

  /// Replaces what photons tell of the exitance, but for caustics. Each replicate has its own rays.
  void Solve(CellExitance& exitance, const Watch& watch) const;

private:
  void AddRays(
    const Receiver& receiver, const GatherSequence& sequence, std::vector<Ray>& rays) const;
  std::vector<LinkTable> FindLinks(
    const CellExitance& exitance, std::vector<std::uint32_t>& placeOf, const Watch& watch) const;

  GatherScene Gathered;
  SharesOfSides Shares;
  /// Along each side of a square of strata, one ray of a replicate of a side in each.
  std::size_t Strata;
  std::vector<std::uint32_t> Seen; ///< Sides, rising, without those that send back no light.
};

} // namespace PhotonTransport
