// SPDX-License-Identifier: BSD-3-Clause
// How a run traces its rounds, alone or with other ranks.
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// A round ends with this many times the photons of the one before. Towards a target rounds are
/// short enough to stop near it; otherwise they are so long that measuring the error costs little.
constexpr double GrowthTowardsTarget = 1.5;
constexpr double Growth = 2.0;

/// Photons of a slice for each vertex: adding up the threads' sums costs a few photons' time a
/// vertex. Where lamps are kept apart most of their slots are empty, which costs less.
constexpr std::uint64_t SlicePhotonsPerVertex = 2;
constexpr std::uint64_t MostLampsInSlice = 4; // or a pause would have to wait
constexpr std::uint64_t LeastSlice = 256;     // blocks

/// The first round of each replicate, in blocks: small, so that something is known soon, but not
/// below a photon a vertex, or adding up and measuring the error would cost more than tracing.
constexpr std::uint64_t FirstRound = 8;

} // namespace

std::uint64_t IlluminationRun::NextRound(const StopRules& rules) const
{
  const std::uint64_t replicates = this->Sums.replicates.size();
  const std::uint64_t limit = this->BlocksFor(rules.photons);
  const std::uint64_t first =
    std::max<std::uint64_t>(FirstRound, this->LitScene.NumberOfMapVertices() / PhotonBlock);
  const auto traced = static_cast<double>(this->BlocksTraced() / replicates);
  const double growth = rules.relativeError > 0.0 ? GrowthTowardsTarget : Growth;
  double next = std::max(static_cast<double>(first), growth * traced);
  if (this->Second && rules.relativeError == 0.0 && rules.seconds == 0.0)
  {
    next = static_cast<double>(limit); // a second pass in between would be for nothing
  }
  if (next * GrowthTowardsTarget > static_cast<double>(limit))
  {
    next = static_cast<double>(limit); // rather than leave a small last round
  }
  if (rules.relativeError > 0.0 && !this->Rows.empty())
  {
    // A little more than predicted, lest the round ends just short of the target.
    constexpr double Reserve = 1.02;
    const double enough =
      Reserve * this->Rows.back().predictedPhotons / static_cast<double>(replicates * PhotonBlock);
    next = std::min(next, std::max(enough, traced + 1.0));
  }
  return std::min(limit, static_cast<std::uint64_t>(std::ceil(next)));
}

std::optional<StopReason> IlluminationRun::TraceRound(
  const StopRules& rules, const ProgressMonitor& monitor)
{
  const std::uint64_t end = this->NextRound(rules);
  if (this->Sharing->AreSeveral())
  {
    this->Part = this->Tracer.EmptySums();
  }
  std::optional<StopReason> reason;
  for (std::uint32_t r = 0; !reason && r < this->Sums.replicates.size(); ++r)
  {
    reason = this->TraceReplicate(r, end, rules, monitor);
  }
  this->Part = {}; // what is made of the map next needs as much
  this->Tracer.FreeSums();
  return reason;
}

/// Traces a replicate up to a block, slice after slice. Ranks have a part of each slice, and add up
/// at the end.
std::optional<StopReason> IlluminationRun::TraceReplicate(
  std::uint32_t number, std::uint64_t end, const StopRules& rules, const ProgressMonitor& monitor)
{
  const std::uint64_t slice = this->Sharing->Number() *
    std::max<std::uint64_t>(LeastSlice,
      SlicePhotonsPerVertex * this->LitScene.NumberOfMapVertices() *
        std::min<std::uint64_t>(MostLampsInSlice, this->Sums.front.lamps) / PhotonBlock);
  std::optional<StopReason> reason;
  std::uint64_t next = this->BlocksOf(number);
  while (!reason && next < end)
  {
    const std::uint64_t count = std::min(slice, end - next);
    if (!this->TraceSlice(number, next, count, rules, monitor))
    {
      reason = StopReason::Abort;
    }
    else if (rules.seconds > 0.0 && this->SecondsTraced >= rules.seconds)
    {
      reason = StopReason::TimeLimit;
    }
    else if (rules.stopSoon && rules.stopSoon())
    {
      reason = StopReason::Paused;
    }
    next += count;
  }
  if (this->Sharing->AreSeveral())
  {
    SumOver(*this->Sharing, this->Part);
    this->Sums.Add(number, this->Part);
  }
  return reason;
}

bool IlluminationRun::TraceSlice(std::uint32_t number, std::uint64_t first, std::uint64_t count,
  const StopRules& rules, const ProgressMonitor& monitor)
{
  const std::uint64_t ranks = this->Sharing->Number();
  const std::uint64_t begin = first + count * this->Sharing->Index() / ranks;
  const std::uint64_t end = first + count * (this->Sharing->Index() + 1) / ranks;
  const std::uint64_t before = first - this->BlocksOf(number);
  const Monitor report = [&](std::uint64_t done)
  { return monitor(this->ProgressTowards(rules, before + done * ranks)); };
  bool goOn = true;
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    const auto add = [&](IlluminationSums& part)
    {
      if (this->Sharing->AreSeveral())
      {
        MoveInto(this->Part, part);
      }
      else
      {
        this->Sums.Add(number, part);
      }
    };
    goOn = this->Tracer.Trace(number, begin, end - begin, add, monitor ? report : Monitor());
    goOn = !this->Sharing->Any(!goOn);
  }
  this->WithoutGaps = goOn;
  this->AgreeOnTime();
  return goOn;
}

} // namespace PhotonTransport
