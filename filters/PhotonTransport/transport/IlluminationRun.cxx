// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/IlluminationRun.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/transport/ParallelFor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <string>

namespace PhotonTransport
{
namespace
{

/// A round ends with this many times the photons of the one before: often enough to stop near a
/// target, or else seldom enough that measuring the error costs little.
constexpr double GrowthTowardsTarget = 1.5;
constexpr double Growth = 2.0;

/// Photons of a slice for each vertex: adding up the threads' sums costs a few photons' time a
/// vertex.
constexpr std::uint64_t SlicePhotonsPerVertex = 2;
constexpr std::uint64_t LeastSlice = 256; // blocks

/// The first round of each replicate, in blocks: small, so that something is known soon, but not
/// below a photon a vertex, or adding up and measuring the error would cost more than tracing.
constexpr std::uint64_t FirstRound = 8;

/// Adds the time of its life to a total.
class Stopwatch
{
public:
  explicit Stopwatch(double& total)
    : Total(total)
  {
  }
  ~Stopwatch()
  {
    const auto passed = std::chrono::steady_clock::now() - this->Start;
    this->Total += std::chrono::duration<double>(passed).count();
  }

private:
  double& Total;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

[[noreturn]] void RefuseRule(const std::string& message)
{
  throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message);
}

} // namespace

void Validate(const StopRules& rules)
{
  // A vertex that every photon hits at full weight sums up to 2^33 of them.
  constexpr std::uint64_t MostPhotons = 10'000'000'000u;
  if (rules.photons < 1 || rules.photons > MostPhotons)
  {
    RefuseRule("the number of photons is " + std::to_string(rules.photons) +
      "; it must be between 1 and " + std::to_string(MostPhotons));
  }
  if (!(rules.relativeError >= 0.0) || !std::isfinite(rules.relativeError))
  {
    RefuseRule("the target relative error is " + std::to_string(rules.relativeError) +
      "; it must be 0 (no target) or more");
  }
  if (!(rules.seconds >= 0.0) || !std::isfinite(rules.seconds))
  {
    RefuseRule(
      "the time limit is " + std::to_string(rules.seconds) + " s; it must be 0 (none) or more");
  }
}

IlluminationRun::IlluminationRun(
  const Scene& scene, const Lamp& lamp, const TraceSettings& settings)
  : Surroundings(scene)
  , Tracer(scene, lamp, settings)
  , Replicates(settings.replicates, Replicate{ this->Tracer.EmptySums() })
{
}

StopReason IlluminationRun::Advance(const StopRules& rules, const ProgressMonitor& monitor)
{
  Validate(rules);
  this->LargestFraction = 0.0;
  std::optional<StopReason> reason = this->RuleReached(rules);
  while (!reason)
  {
    reason = this->TraceRound(rules, monitor);
    this->AddRow(rules);
    if (!reason)
    {
      reason = this->RuleReached(rules);
    }
  }
  return *reason;
}

std::uint64_t IlluminationRun::BlocksTraced() const
{
  std::uint64_t blocks = 0;
  for (const Replicate& replicate : this->Replicates)
  {
    blocks += replicate.blocks;
  }
  return blocks;
}

std::optional<StopReason> IlluminationRun::RuleReached(const StopRules& rules) const
{
  if (rules.relativeError > 0.0 && !this->Rows.empty() &&
    this->Rows.back().relativeError <= rules.relativeError)
  {
    return StopReason::RelativeError;
  }
  if (this->BlocksTraced() * PhotonBlock >= rules.photons)
  {
    return StopReason::PhotonLimit;
  }
  if (rules.seconds > 0.0 && this->SecondsTraced >= rules.seconds)
  {
    return StopReason::TimeLimit;
  }
  return std::nullopt;
}

std::uint64_t IlluminationRun::NextRound(const StopRules& rules) const
{
  const std::uint64_t replicates = this->Replicates.size();
  const std::uint64_t limit =
    (rules.photons + replicates * PhotonBlock - 1) / (replicates * PhotonBlock);
  const std::uint64_t first =
    std::max<std::uint64_t>(FirstRound, this->Surroundings.Vertices().size() / PhotonBlock);
  const auto traced = static_cast<double>(this->BlocksTraced() / replicates);
  const double growth = rules.relativeError > 0.0 ? GrowthTowardsTarget : Growth;
  double next = std::max(static_cast<double>(first), growth * traced);
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
  const std::uint64_t slice = std::max<std::uint64_t>(
    LeastSlice, SlicePhotonsPerVertex * this->Surroundings.Vertices().size() / PhotonBlock);
  for (std::uint32_t r = 0; r < this->Replicates.size(); ++r)
  {
    while (this->Replicates[r].blocks < end)
    {
      const std::uint64_t count = std::min(slice, end - this->Replicates[r].blocks);
      if (!this->TraceSlice(r, count, rules, monitor))
      {
        return StopReason::Abort;
      }
      if (rules.seconds > 0.0 && this->SecondsTraced >= rules.seconds)
      {
        return StopReason::TimeLimit;
      }
    }
  }
  return std::nullopt;
}

bool IlluminationRun::TraceSlice(
  std::uint32_t number, std::uint64_t count, const StopRules& rules, const ProgressMonitor& monitor)
{
  const Stopwatch stopwatch(this->SecondsTraced);
  Replicate& replicate = this->Replicates[number];
  const Monitor report = [&](std::uint64_t done)
  { return monitor(this->ProgressTowards(rules, done)); };
  this->Whole = this->Tracer.Trace(
    number, replicate.blocks, count, replicate.sums, monitor ? report : Monitor());
  replicate.blocks = replicate.sums.balance.emitted / PhotonBlock;
  return this->Whole;
}

void IlluminationRun::AddRow(const StopRules& rules)
{
  Accuracy row;
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    MeasureErrors(row, this->Front(), this->Surroundings.VertexAreas());
  }
  const PhotonBalance balance = this->Balance();
  row.photons = balance.emitted;
  row.seconds = this->SecondsTraced;
  row.segmentsPerSecond = static_cast<double>(balance.segments) / row.seconds;
  if (rules.relativeError > 0.0)
  {
    PredictCost(row, this->Rows, rules.relativeError);
  }
  this->Rows.push_back(row);
}

RunProgress IlluminationRun::ProgressTowards(const StopRules& rules, std::uint64_t blocksOfSlice)
{
  const auto photons = static_cast<double>((this->BlocksTraced() + blocksOfSlice) * PhotonBlock);
  const double seconds = this->SecondsTraced;
  double fraction = photons / static_cast<double>(rules.photons);
  if (rules.seconds > 0.0)
  {
    fraction = std::max(fraction, seconds / rules.seconds);
  }
  if (rules.relativeError > 0.0 && !this->Rows.empty())
  {
    fraction = std::max(fraction, photons / this->Rows.back().predictedPhotons);
  }
  // Predictions change their mind; a progress bar must not.
  this->LargestFraction = std::clamp(fraction, this->LargestFraction, 1.0);
  return { this->LargestFraction, seconds * (1.0 / this->LargestFraction - 1.0) };
}

PhotonBalance IlluminationRun::Balance() const
{
  PhotonBalance balance;
  for (const Replicate& replicate : this->Replicates)
  {
    balance += replicate.sums.balance;
  }
  return balance;
}

double IlluminationRun::FluxCutByWeightBound() const
{
  FixedPoint cut = 0;
  for (const Replicate& replicate : this->Replicates)
  {
    cut += replicate.sums.cutByWeightBound;
  }
  const auto emitted = static_cast<double>(this->Balance().emitted);
  return emitted > 0.0 ? this->Flux() / emitted * FromCoarseFixedPoint(cut) : 0.0;
}

/// E_i = (flux / N) V_i / A_i, DESIGN 4.1, and its standard error from the replicates.
IlluminationMap IlluminationRun::Side(std::vector<VertexSums> IlluminationSums::*side) const
{
  const std::vector<double>& areas = this->Surroundings.VertexAreas();
  const std::size_t vertices = areas.size();
  IlluminationMap map{ std::vector<double>(vertices, 0.0), std::vector<double>(vertices, 0.0),
    std::vector<double>(vertices, 0.0), std::vector<std::uint64_t>(vertices, 0) };
  const auto emitted = static_cast<double>(this->Balance().emitted);
  const auto evaluate = [&](std::size_t v)
  {
    VertexSums total;
    ReplicateStatistics statistics;
    for (const Replicate& replicate : this->Replicates)
    {
      const VertexSums& sums = (replicate.sums.*side)[v];
      const auto photons = static_cast<double>(replicate.sums.balance.emitted);
      total += sums;
      statistics.Add(FromFixedPoint(sums.direct + sums.indirect) / photons, photons);
    }
    const double luxPerWeight = this->Flux() / areas[v];
    map.direct[v] = luxPerWeight * FromFixedPoint(total.direct) / emitted;
    map.indirect[v] = luxPerWeight * FromFixedPoint(total.indirect) / emitted;
    map.standardError[v] = luxPerWeight * statistics.StandardError();
    map.photonHits[v] = total.hits;
  };
  ParallelFor(0, vertices,
    [&](const tbb::blocked_range<std::uint64_t>& range)
    {
      for (std::size_t v = range.begin(); v < range.end(); ++v)
      {
        if (areas[v] > 0.0 && emitted > 0.0)
        {
          evaluate(v);
        }
      }
    });
  return map;
}

GroupMeans IlluminationRun::FrontByGroups() const
{
  std::array<double, Groups> photons{};
  for (std::size_t r = 0; r < this->Replicates.size(); ++r)
  {
    photons[r % Groups] += static_cast<double>(this->Replicates[r].sums.balance.emitted);
  }
  if (*std::min_element(photons.begin(), photons.end()) == 0.0)
  {
    return {};
  }
  const std::vector<double>& areas = this->Surroundings.VertexAreas();
  const double all = std::accumulate(photons.begin(), photons.end(), 0.0);
  const auto meansOf = [&](std::size_t v, FixedPoint VertexSums::*part)
  {
    std::array<FixedPoint, Groups> sums{};
    for (std::size_t r = 0; r < this->Replicates.size(); ++r)
    {
      sums[r % Groups] += this->Replicates[r].sums.front[v].*part;
    }
    const FixedPoint total = std::accumulate(sums.begin(), sums.end(), FixedPoint{ 0 });
    GroupValues means{};
    double unweighted = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      means[g] = FromFixedPoint(sums[g]) / photons[g];
      unweighted += means[g] / Groups;
    }
    // Groups may differ in photons after a time limit; their plain mean must be that of the map.
    const double shift = FromFixedPoint(total) / all - unweighted;
    for (double& mean : means)
    {
      mean = this->Flux() / areas[v] * (mean + shift);
    }
    return means;
  };
  GroupMeans groups{ std::vector<GroupValues>(areas.size()),
    std::vector<GroupValues>(areas.size()) };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, areas.size()),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t v = range.begin(); v < range.end(); ++v)
      {
        if (areas[v] > 0.0)
        {
          groups.direct[v] = meansOf(v, &VertexSums::direct);
          groups.indirect[v] = meansOf(v, &VertexSums::indirect);
        }
      }
    });
  return groups;
}

} // namespace PhotonTransport
