// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/IlluminationRun.h"

#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/transport/MemoryBudget.h"
#include "PhotonTransport/transport/SecondPass.h"
#include "PhotonTransport/transport/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// The share of the second pass in the time of a run, for want of a better guess.
constexpr double GatheringShare = 0.7;

} // namespace

IlluminationRun::IlluminationRun(const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings, Openings openings, MemoryBudget* memory)
  : LitScene(scene)
  , Settings(settings)
  , Cells(SecondPass::CellsFor(scene, settings))
  , Tracer(scene, lighting, settings, this->Cells.get(), this->Cells ? Openings() : openings)
  , Traced(Undimmed(lighting, settings))
  , Now(this->Traced)
  , EffectsNow(this->Tracer.EffectsInUse())
  , Second(this->Cells ? std::make_unique<SecondPass>(
                           scene, *this->Cells, this->Tracer, settings, std::move(openings))
                       : nullptr)
{
  if (memory)
  {
    memory->KnowScene(scene.NumberOfParts(), this->Cells ? this->Cells->Number() : 0);
  }
  if (memory && this->Second)
  {
    this->Second->WatchLinks([memory](std::uint64_t bytes) { memory->KnowLinks(bytes); });
  }
  this->Sums = ReplicateSums(settings.replicates, this->Tracer.EmptySums());
  this->Relight(lighting);
}

IlluminationRun::~IlluminationRun() = default;

void IlluminationRun::WorkAlone()
{
  this->ShareWith(this->Alone);
}

void IlluminationRun::ShareWith(Ranks& ranks)
{
  this->Sharing = &ranks;
  if (this->Second)
  {
    this->Second->ShareWith(ranks);
  }
}

StopReason IlluminationRun::Advance(const StopRules& rules, const ProgressMonitor& monitor)
{
  Validate(rules);
  this->LargestFraction = 0.0;
  if (!this->Rows.empty() && this->FacetsCount != rules.countFacetError)
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    this->FacetsCount = rules.countFacetError;
    this->MeasureErrorsOf(this->Rows.back());
  }
  this->AgreeOnTime();
  if (rules.relativeError > 0.0 && !this->Rows.empty()) // the target or the region may be another
  {
    PredictCost(this->Rows.back(), this->Rows, rules.relativeError);
  }
  std::optional<StopReason> reason = this->RuleReached(rules);
  if (reason == StopReason::PhotonLimit && rules.preliminary && this->IsPreliminary())
  {
    this->Second->ShowFirstPass(this->Sums);
    return *reason;
  }
  if (reason && this->Second && !this->Second->HasGathered(this->Sums))
  {
    // An abort has left photons without a second pass.
    reason = this->GatherRound(rules, monitor).value_or(*reason);
    this->AddRow(rules);
  }
  while (!reason)
  {
    reason = this->TraceRound(rules, monitor);
    if (!reason && rules.preliminary && this->IsPreliminary() &&
      this->RuleReached(rules) == StopReason::PhotonLimit)
    {
      const Stopwatch stopwatch(this->SecondsTraced);
      this->Second->ShowFirstPass(this->Sums);
      return StopReason::PhotonLimit;
    }
    if (!reason || (this->Second && !this->Second->HasGathered()))
    {
      const std::optional<StopReason> gathered = this->GatherRound(rules, monitor);
      reason = reason ? reason : gathered;
    }
    this->AddRow(rules);
    if (!reason)
    {
      reason = this->RuleReached(rules);
    }
  }
  return *reason;
}

/// The second pass over what photons have lit up to now.
std::optional<StopReason> IlluminationRun::GatherRound(
  const StopRules& rules, const ProgressMonitor& monitor)
{
  if (!this->Second)
  {
    return std::nullopt;
  }
  bool aborted = false;
  bool paused = false;
  bool done = false;
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    const FinalGathering::Progress progress = [&](double share)
    {
      const double seconds = stopwatch.Seconds();
      aborted = monitor && !monitor(this->ProgressOfGathering(rules, share, seconds));
      paused = !aborted && rules.stopSoon && rules.stopSoon();
      return !aborted && !paused &&
        (rules.seconds == 0.0 || this->SecondsTraced + seconds < rules.seconds);
    };
    done = this->Second->Gather(this->Sums, progress);
  }
  this->AgreeOnTime();
  aborted = this->Sharing->Any(aborted);
  if (done)
  {
    return std::nullopt;
  }
  return aborted ? StopReason::Abort : (paused ? StopReason::Paused : StopReason::TimeLimit);
}

RunProgress IlluminationRun::ProgressOfGathering(
  const StopRules& rules, double done, double seconds)
{
  RunProgress progress = this->ProgressTowards(rules, 0);
  progress.isGathering = true;
  if (rules.relativeError == 0.0 && rules.seconds == 0.0) // this is the only, last part
  {
    this->LargestFraction = progress.fraction =
      std::max(this->LargestFraction, GatheringShare * done + 1.0 - GatheringShare);
    progress.secondsLeft = done > 0.0 ? seconds * (1.0 / done - 1.0) : 0.0;
  }
  return progress;
}

std::optional<StopReason> IlluminationRun::RuleReached(const StopRules& rules) const
{
  if (this->Sums.AreFull()) // a round at most triples the photons
  {
    return StopReason::SumsFull;
  }
  if (rules.relativeError > 0.0 && !this->Rows.empty() &&
    this->Rows.back().Targeted().relativeError <= rules.relativeError)
  {
    return StopReason::RelativeError;
  }
  if (rules.relativeError > 0.0 && this->BlocksTraced() * PhotonBlock >= MostPhotonsInTheDark &&
    !this->Sums.AnyLight(&ReplicateSums::front) && !this->Sums.AnyLight(&ReplicateSums::back))
  {
    return StopReason::NothingLit;
  }
  if (rules.relativeError > 0.0 && rules.countFacetError && !this->Rows.empty() &&
    FacetsAreTooLarge(this->Rows.back().Targeted(), rules.relativeError))
  {
    return StopReason::FacetsTooLarge;
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

bool IlluminationRun::IsPreliminary() const
{
  return this->Second && !this->Second->HasGathered();
}

bool IlluminationRun::CanGoOnTo(std::uint64_t photons) const
{
  return this->CanGoOn() &&
    this->BlocksTraced() <= this->BlocksFor(photons) * this->Sums.replicates.size();
}

void IlluminationRun::SetRegion(const std::vector<double>& shares)
{
  std::vector<double> areas(shares.size());
  std::transform(shares.begin(), shares.end(), this->LitScene.VertexAreas().begin(), areas.begin(),
    std::multiplies<>());
  if (areas == this->RegionAreas)
  {
    return;
  }
  this->RegionAreas = std::move(areas);
  for (Accuracy& row : this->Rows)
  {
    row.region.reset(); // their maps are gone
  }
  if (!this->Rows.empty())
  {
    this->MeasureErrorsOf(this->Rows.back());
  }
}

void IlluminationRun::MeasureErrorsOf(Accuracy& row) const
{
  const bool onlyBacks =
    !this->Sums.AnyLight(&ReplicateSums::front) && this->Sums.AnyLight(&ReplicateSums::back);
  const IlluminationMap map = onlyBacks ? this->Back() : this->Front();
  const std::vector<double> facetError =
    this->FacetsCount ? this->FacetErrorOf(map) : std::vector<double>();
  static_cast<MapErrors&>(row) = MeasureErrors(map, this->LitScene.VertexAreas(), facetError);
  if (!this->RegionAreas.empty())
  {
    row.region = MeasureErrors(map, this->RegionAreas, facetError);
  }
}

void IlluminationRun::AddRow(const StopRules& rules)
{
  Accuracy row;
  {
    const Stopwatch stopwatch(this->SecondsTraced);
    this->FacetsCount = rules.countFacetError;
    this->MeasureErrorsOf(row);
  }
  this->AgreeOnTime();
  const PhotonBalance balance = this->Balance();
  row.photons = balance.emitted;
  row.gatherRays = this->Second ? this->Second->Rays(this->Sums) : 0;
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
  if (this->Second)
  {
    fraction *= 1.0 - GatheringShare;
  }
  // Predictions rise and fall, but progress must not fall.
  this->LargestFraction = std::clamp(fraction, this->LargestFraction, 1.0);
  return { this->LargestFraction, seconds * (1.0 / this->LargestFraction - 1.0) };
}

} // namespace PhotonTransport
