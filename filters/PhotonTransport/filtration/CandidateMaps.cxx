// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/CandidateMaps.h"

namespace PhotonTransport
{
namespace
{

std::vector<SpectralFilter> MakeLadder()
{
  std::vector<SpectralFilter> filters;
  for (const double time : KernelTimes)
  {
    filters.push_back(SpectralFilter::TwicedHeat(time));
  }
  return filters;
}

/// Their series take a millisecond, so they are found once.
const std::vector<SpectralFilter>& Ladder()
{
  static const std::vector<SpectralFilter> filters = MakeLadder();
  return filters;
}

} // namespace

CandidateMaps::CandidateMaps(
  const SmoothingGraph& graph, const GroupColumns& map, const FiltrationMonitor& monitor)
  : Map(map)
  , Smoothed(Apply<Groups>(graph, Ladder(), map, monitor))
{
}

} // namespace PhotonTransport
