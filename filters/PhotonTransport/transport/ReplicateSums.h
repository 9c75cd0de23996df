// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/IlluminationMap.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/statistics/GroupMeans.h"
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
  /// [replicate][vertex][channel] The light by colour; empty without colour.
  std::vector<std::vector<FixedPoint>> colours;

  PhotonBalance Balance() const;
  /// [source] Summed over the replicates.
  std::vector<PhotonBalance> BalancesBySource() const;
  std::vector<Arrivals> ArrivalsBySource() const;
  /// Weight that the bound cut off. Times flux / photons it is in lm.
  double CutByWeightBound(const std::vector<float>& startWeights) const;

  /// E_i = (flux / N) V_i / A_i and its standard error, which is that of the replicates or, where a
  /// vertex has few hits, that of FewHits. @param flux lm. @param areas [vertex] m^2.
  /// @param startWeights [source] See Emitter.
  IlluminationMap Map(Side side, double flux, const std::vector<double>& areas,
    const std::vector<float>& startWeights) const;

  /// See IlluminationRun::FrontByGroups.
  GroupMeans FrontByGroups(double flux, const std::vector<double>& areas) const;

  /// See IlluminationRun.
  std::vector<std::array<double, 3>> FrontByColour(
    double flux, const std::vector<double>& areas) const;
  /// The standard errors of these, lx: as Map has that of all light. Where a vertex has few hits,
  /// a colour has that of FewHits times the root mean square of its shares in the hits, and in two
  /// more that are as those of all vertices.
  std::vector<std::array<double, 3>> ColourErrors(
    double flux, const std::vector<double>& areas, const std::vector<float>& startWeights) const;
  std::vector<double> FrontOfLamp(
    std::size_t lamp, double flux, const std::vector<double>& areas) const;

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
};

} // namespace PhotonTransport
