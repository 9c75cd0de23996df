// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/statistics/Accuracy.h"
#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/ReplicateSums.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// When a run is over: the first rule reached wins.
struct StopRules
{
  /// Photons to stop at, [1, 1e10], rounded up: each replicate gets whole blocks of 256.
  std::uint64_t photons = 1'000'000;
  /// See Accuracy::relativeError: of the front, or of the back where only that is lit. 0 is no
  /// target.
  double relativeError = 0.0;
  double seconds = 0.0; ///< Of tracing; 0 is no limit.
};

/// A run towards a relative error ends when it has traced so many photons and none of them has
/// registered on any side. With 95 % confidence fewer than 3 of so many photons would register on
/// average, and no target can be met with so few. Without this rule the run would go on to
/// StopRules::photons.
constexpr std::uint64_t MostPhotonsInTheDark = 1u << 20;

/// Throws InvalidInput that names the rule.
void Validate(const StopRules& rules);

enum class StopReason : int
{
  PhotonLimit,
  RelativeError,
  TimeLimit,
  Abort,
  SumsFull,  ///< Another round might overflow the sum of some vertex: ReplicateSums::AreFull.
  NothingLit ///< There is a target, and of MostPhotonsInTheDark none has registered.
};

struct RunProgress
{
  double fraction;    ///< [0, 1], of the rule that is nearest to its end; never falls.
  double secondsLeft; ///< An estimate, from the fraction and the seconds so far.
};

/// Called now and then from the thread that called Advance; returns false to abort.
using ProgressMonitor = std::function<bool(const RunProgress&)>;

/// Traces a map in rounds, each over all replicates, and can go on where it stopped. The result is
/// a function of the number of photons: running to N and on to 2N gives the bits of running to 2N
/// at once.
class IlluminationRun
{
public:
  /// Throws InvalidInput as PhotonTracer does. @param scene Must outlive the run.
  IlluminationRun(const Scene& scene, const Lighting& lighting, const TraceSettings& settings);

  /// Traces until a rule ends the run; what earlier calls have traced counts, too. However it ends,
  /// there is a valid map. The time limit is checked between slices of the work, an abort within
  /// them. Throws InvalidInput for rules out of range.
  StopReason Advance(const StopRules& rules, const ProgressMonitor& monitor = {});

  /// False once an abort has left gaps in the sequences: the map is valid, but going on would not
  /// give the bits that a run in one go gives.
  bool CanGoOn() const { return this->WithoutGaps; }
  /// Also false if a run to so many photons would have ended before where this one is.
  bool CanGoOnTo(std::uint64_t photons) const;

  IlluminationMap Front() const { return this->MapOf(&IlluminationSums::front); }
  /// Only if the settings ask for the back to be registered.
  IlluminationMap Back() const { return this->MapOf(&IlluminationSums::back); }

  /// The front as four estimates whose mean is Front(). Empty if the run ended so soon that not all
  /// four have photons, or if there are fewer than four replicates.
  GroupMeans FrontByGroups() const
  {
    return this->Sums.FrontByGroups(this->Flux(), this->LitScene.VertexAreas());
  }

  /// [vertex] The light on the front by colour, lx. White light has three equal channels; the sum
  /// weighted by LuminousWeights is that of Front(). Empty where the scene calls for no colour.
  std::vector<std::array<double, 3>> FrontByColour() const
  {
    return this->Sums.FrontByColour(this->Flux(), this->LitScene.VertexAreas());
  }
  /// [vertex] The light on the front from one luminaire, lx; 0 unless TraceSettings::lampsApart.
  std::vector<double> FrontOfLamp(std::size_t lamp) const
  {
    return this->Sums.FrontOfLamp(lamp, this->Flux(), this->LitScene.VertexAreas());
  }

  PhotonBalance Balance() const { return this->Sums.Balance(); }
  /// Where each luminaire's photons first arrived. [luminaire]
  std::vector<Arrivals> ArrivalsByLamp() const { return this->Sums.ArrivalsByLamp(); }
  /// See PhotonTracer.
  std::optional<glm::uvec3> CornersLitFromBehind(std::size_t lamp) const
  {
    return this->Tracer.CornersLitFromBehind(static_cast<std::uint32_t>(lamp));
  }
  double Flux() const { return this->Tracer.Flux(); }
  double FluxOf(std::uint64_t photons) const; ///< lm that so many photons stand for.
  double FluxCutByWeightBound() const;        ///< lm
  /// The flux that an effect which is switched off would have carried on, lm.
  double FluxSwitchedOff(Scattering scattering) const;
  double Seconds() const { return this->SecondsTraced; }
  const Effects& EffectsInUse() const { return this->Tracer.EffectsInUse(); }

  /// One row for each round; the last one is of the map as it is.
  const std::vector<Accuracy>& Rounds() const { return this->Rows; }

private:
  /// Blocks of photons that a replicate has traced.
  std::uint64_t BlocksOf(std::uint32_t replicate) const
  {
    return this->Sums.replicates[replicate].balance.emitted / PhotonBlock;
  }
  /// Blocks of each replicate for at least so many photons in all.
  std::uint64_t BlocksFor(std::uint64_t photons) const
  {
    const std::uint64_t inOneOfEach = this->Sums.replicates.size() * PhotonBlock;
    return (photons + inOneOfEach - 1) / inOneOfEach;
  }
  IlluminationMap MapOf(ReplicateSums::Side side) const
  {
    return this->Sums.Map(side, this->Flux(), this->LitScene.VertexAreas());
  }
  std::uint64_t BlocksTraced() const { return this->Balance().emitted / PhotonBlock; }
  std::optional<StopReason> RuleReached(const StopRules& rules) const;
  std::uint64_t NextRound(const StopRules& rules) const;
  std::optional<StopReason> TraceRound(const StopRules& rules, const ProgressMonitor& monitor);
  bool TraceSlice(std::uint32_t number, std::uint64_t count, const StopRules& rules,
    const ProgressMonitor& monitor);
  void AddRow(const StopRules& rules);
  RunProgress ProgressTowards(const StopRules& rules, std::uint64_t blocksOfSlice);

  const Scene& LitScene;
  PhotonTracer Tracer;
  ReplicateSums Sums;
  std::vector<Accuracy> Rows;
  double SecondsTraced = 0.0;
  double LargestFraction = 0.0;
  bool WithoutGaps = true;
};

} // namespace PhotonTransport
