// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/GroupStatistics.h"

#include <array>
#include <vector>

namespace PhotonTransport
{

/// Times of the heat kernels; each smooths sqrt(2) times as wide as the one before.
constexpr std::array<double, 8> KernelTimes{ 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0 };
constexpr std::size_t Candidates = KernelTimes.size() + 1; ///< Number 0 is the map itself.

/// A value for each candidate, and some to spare, at each vertex.
using CandidateColumns = Columns<12>;
static_assert(Candidates < 12);

/// A map and what twiced heat kernels of eight widths, from 1 to 11 vertex distances, make of it.
class CandidateMaps
{
public:
  /// @param map Must outlive this.
  CandidateMaps(
    const SmoothingGraph& graph, const GroupColumns& map, const FiltrationMonitor& monitor);

  const Group& At(std::size_t candidate, std::size_t v) const
  {
    return candidate == 0 ? this->Map[v] : this->Smoothed[candidate - 1][v];
  }
  std::size_t Vertices() const { return this->Map.size(); }

private:
  const GroupColumns& Map;
  std::vector<GroupColumns> Smoothed;
};

} // namespace PhotonTransport
