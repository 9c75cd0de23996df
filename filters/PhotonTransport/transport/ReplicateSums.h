// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/statistics/GroupMeans.h"
#include "PhotonTransport/transport/MapScale.h"
#include "PhotonTransport/transport/SideSums.h"

#include <array>
#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// What the replicates of a run have summed up, and the maps that follow from it.
struct ReplicateSums
{
  using Side = SideSums ReplicateSums::*;

  ReplicateSums() = default;
  /// @param empty Without light, of the sides, cells and layers that a replicate has.
  ReplicateSums(std::size_t numberOfReplicates, IlluminationSums empty);

  /// Adds what a replicate has got, and clears it.
  void Add(std::size_t replicate, IlluminationSums& sums);

  SideSums front;
  SideSums back;                            ///< Without vertices unless the back is registered.
  std::vector<IlluminationSums> replicates; ///< Without vertices and layers.
  LightLayers layers;                       ///< Of all replicates together.
  /// [replicate][slot][channel] The light by colour; empty without colour.
  std::vector<std::vector<FixedPoint>> colours;

  PhotonBalance Balance() const;
  /// [source] Summed over the replicates.
  std::vector<PhotonBalance> BalancesBySource() const;
  std::vector<Arrivals> ArrivalsBySource() const;
  /// Weight that the bound cut off, by source, without start weights.
  std::vector<double> CutByWeightBound() const;

  /// E_i = (flux / N) sum_l f_l V_il / A_i and its standard error, which is that of the replicates
  /// or, where a vertex has few hits, that of FewHits. V_il is what lamp l has brought, f_l its
  /// factor. Hits of lamps without light do not count.
  IlluminationMap Map(Side side, const MapScale& scale, const LampFactors& factors = {}) const;

  /// See IlluminationRun::FrontByGroups.
  GroupMeans FrontByGroups(const MapScale& scale, const LampFactors& factors = {}) const;

  /// From the layers; see IlluminationRun.
  std::vector<std::array<double, 3>> FrontByColour(
    const MapScale& scale, const LampFactors& factors = {}) const;
  /// The standard errors of these, lx: as Map has that of all light. Where a vertex has few hits,
  /// a colour has that of FewHits times the root mean square of its shares in the hits, and in two
  /// more that are as those of all vertices.
  std::vector<std::array<double, 3>> ColourErrors(
    const MapScale& scale, const LampFactors& factors = {}) const;

  /// Whether anything has registered on that side.
  bool AnyLight(Side side) const;

  /// Whether some vertex's sum over all replicates fills a quarter of its range. Below that, three
  /// times as many photons can't overflow it, and a round at most triples them.
  bool AreFull() const;

  std::vector<double> PhotonsOfReplicates() const;
  /// Whether two replicates or more have photons, so that they can tell a spread.
  bool CanTellSpread() const;

private:
  void AddColours(std::size_t replicate, const LightLayers& ofReplicate);
  void CountFewHits(const SideSums& sums, const MapScale& scale, const LampFactors& factors,
    IlluminationMap& map) const;
};

} // namespace PhotonTransport
