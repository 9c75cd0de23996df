// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/IlluminationRun.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
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
  // The first round of so many photons can't fill a sum; ReplicateSums::AreFull looks after the
  // later ones.
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
    RefuseRule("the time limit is " + std::to_string(rules.seconds) +
      " s; it must be 0 (none) or more, and finite");
  }
}

IlluminationRun::IlluminationRun(
  const Scene& scene, const Lighting& lighting, const TraceSettings& settings)
  : LitScene(scene)
  , Tracer(scene, lighting, settings)
{
  IlluminationSums empty = this->Tracer.EmptySums();
  this->Sums.layers = std::exchange(empty.layers, {});
  this->Sums.replicates.assign(settings.replicates, empty);
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

std::optional<StopReason> IlluminationRun::RuleReached(const StopRules& rules) const
{
  if (this->Sums.AreFull()) // a round at most triples the photons
  {
    return StopReason::SumsFull;
  }
  if (rules.relativeError > 0.0 && !this->Rows.empty() &&
    this->Rows.back().relativeError <= rules.relativeError)
  {
    return StopReason::RelativeError;
  }
  if (rules.relativeError > 0.0 && this->BlocksTraced() * PhotonBlock >= MostPhotonsInTheDark &&
    !this->Sums.AnyLight(&IlluminationSums::front) && !this->Sums.AnyLight(&IlluminationSums::back))
  {
    return StopReason::NothingLit;
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

bool IlluminationRun::CanGoOnTo(std::uint64_t photons) const
{
  return this->CanGoOn() &&
    this->BlocksTraced() <= this->BlocksFor(photons) * this->Sums.replicates.size();
}

std::uint64_t IlluminationRun::NextRound(const StopRules& rules) const
{
  const std::uint64_t replicates = this->Sums.replicates.size();
  const std::uint64_t limit = this->BlocksFor(rules.photons);
  const std::uint64_t first =
    std::max<std::uint64_t>(FirstRound, this->LitScene.Vertices().size() / PhotonBlock);
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
    LeastSlice, SlicePhotonsPerVertex * this->LitScene.Vertices().size() / PhotonBlock);
  for (std::uint32_t r = 0; r < this->Sums.replicates.size(); ++r)
  {
    while (this->BlocksOf(r) < end)
    {
      const std::uint64_t count = std::min(slice, end - this->BlocksOf(r));
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
  const Monitor report = [&](std::uint64_t done)
  { return monitor(this->ProgressTowards(rules, done)); };
  this->WithoutGaps = this->Tracer.Trace(number, this->BlocksOf(number), count,
    this->Sums.replicates[number], monitor ? report : Monitor(), &this->Sums.layers);
  return this->WithoutGaps;
}

void IlluminationRun::AddRow(const StopRules& rules)
{
  Accuracy row;
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    const bool onlyBacks = !this->Sums.AnyLight(&IlluminationSums::front) &&
      this->Sums.AnyLight(&IlluminationSums::back);
    MeasureErrors(row, onlyBacks ? this->Back() : this->Front(), this->LitScene.VertexAreas());
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
  // Predictions rise and fall, but progress must not fall.
  this->LargestFraction = std::clamp(fraction, this->LargestFraction, 1.0);
  return { this->LargestFraction, seconds * (1.0 / this->LargestFraction - 1.0) };
}

double IlluminationRun::FluxSwitchedOff(Scattering scattering) const
{
  return this->FluxOf(this->Balance().switchedOff[static_cast<unsigned>(scattering)]);
}

double IlluminationRun::FluxOf(std::uint64_t photons) const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  return emitted > 0.0 ? this->Flux() / emitted * static_cast<double>(photons) : 0.0;
}

double IlluminationRun::FluxCutByWeightBound() const
{
  const auto emitted = static_cast<double>(this->Balance().emitted);
  return emitted > 0.0 ? this->Flux() / emitted * this->Sums.CutByWeightBound() : 0.0;
}

} // namespace PhotonTransport
