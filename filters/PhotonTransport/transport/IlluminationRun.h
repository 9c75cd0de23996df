// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/registration/PhotonHit.h"
#include "PhotonTransport/statistics/Accuracy.h"
#include "PhotonTransport/statistics/ShareOfLight.h"
#include "PhotonTransport/threads/Ranks.h"
#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/ReplicateSums.h"
#include "PhotonTransport/transport/StopRules.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace PhotonTransport
{

struct AdaptiveLimits;
class MemoryBudget;
struct RefinedMap;
class SecondPass;

struct RunProgress
{
  double fraction;          ///< [0, 1], of the rule that is nearest to its end; never falls.
  double secondsLeft;       ///< An estimate, from the fraction and the seconds so far.
  bool isGathering = false; ///< The second pass is at work.
};

/// Called now and then from the thread that called Advance; returns false to abort.
using ProgressMonitor = std::function<bool(const RunProgress&)>;

/// Traces a map in rounds, each over all replicates, and can go on where it stopped. The result is
/// a function of the number of photons: running to N and on to 2N gives the bits of running to 2N
/// at once. Ranks that share a run each make one of the same scene and call the same functions;
/// all get the bits that one rank alone gets.
class IlluminationRun
{
public:
  /// Throws InvalidInput as PhotonTracer does. @param scene Must outlive the run.
  /// @param openings Through which light from afar enters: see FindOpenings. Without them the light
  /// is the same, with more noise. @param memory Is told what becomes known of the need, and may
  /// refuse it by an InvalidInput here and in what follows; or null. Must outlive the run.
  IlluminationRun(const Scene& scene, const Lighting& lighting, const TraceSettings& settings,
    Openings openings = {}, MemoryBudget* memory = nullptr);
  ~IlluminationRun();

  /// From now on these ranks share the work, until it is called again. Each must have the same run.
  void ShareWith(Ranks& ranks);
  /// From now on this is the one rank.
  void WorkAlone();

  /// Traces until a rule ends the run; what earlier calls have traced counts, too. However it ends,
  /// there is a valid map. Time limit and pause are checked between slices of the work, an abort
  /// within them. The first rank tells the time, and an abort on any rank is one on all. Throws
  /// InvalidInput for rules out of range.
  StopReason Advance(const StopRules& rules, const ProgressMonitor& monitor = {});

  /// Makes the map that of another lighting, whose lamps differ from those that were traced in
  /// their fluxes, dimming and colours alone (see RelightingOf), from what was traced: no photon
  /// is. All that the run tells is then of that lighting: maps, errors, fluxes, and the last row of
  /// Rounds(), which becomes the only one; numbers of photons stay. Where lamps are not kept apart,
  /// by TraceSettings::lampsApart in Method::PhotonTracing, all their light may differ by one
  /// factor, and nothing else; nor may colours differ where facets have colours of their own.
  /// @return Whether that was possible; if not, nothing changes.
  bool Relight(const Lighting& wanted);
  /// Whether Relight has made the map that of another lighting.
  bool IsRelit() const { return this->LightFactor != 1.0 || this->IsOfOtherShares(); }
  /// Whether lamps have other shares of the light than of the photons, or other colours.
  bool IsOfOtherShares() const { return !this->Factors.empty() || this->HasOtherColours; }
  /// Whether photons have other colours than the light that the map is of.
  bool HasOtherColoursThanPhotons() const { return this->HasOtherColours; }

  /// Where accuracy counts: StopRules::relativeError and Accuracy::region are of this region from
  /// now on, and the last row of Rounds() is as well.
  /// @param shares [vertex] Of its area that belongs to the region, [0, 1], not all 0; or empty for
  /// no region.
  void SetRegion(const std::vector<double>& shares);

  /// Whether the second pass of Method::FinalGathering has never been done to its end. The map then
  /// is the mean light on the facets around each vertex, as photons tell it, where it has none of
  /// its own, and there is no row of Rounds() for it. An error as large is told there.
  bool IsPreliminary() const;

  /// False once an abort has left gaps in the sequences: the map is valid, but going on would not
  /// give the bits that a run in one go gives.
  bool CanGoOn() const { return this->WithoutGaps; }
  /// Also false if a run to so many photons would have ended before where this one is.
  bool CanGoOnTo(std::uint64_t photons) const;

  IlluminationMap Front() const;
  /// Only if the settings ask for the back to be registered.
  IlluminationMap Back() const;

  /// [vertex] What the size of facets may have changed in a map of this run, lx; see FacetError.
  /// Empty in Method::FinalGathering, which has no such error.
  std::vector<double> FacetErrorOf(const IlluminationMap& map) const;

  /// The front as four estimates whose mean is Front(). Empty if the run ended so soon that not all
  /// four have photons, if there are fewer than four replicates, and in Method::FinalGathering,
  /// whose noise differs from vertex to vertex independently.
  GroupMeans FrontByGroups() const;

  /// [vertex] The light on the front by colour, lx. White light has three equal channels; the sum
  /// weighted by LuminousWeights is that of Front(). Empty where the scene calls for no colour.
  std::vector<std::array<double, 3>> FrontByColour() const;
  /// [vertex] The standard errors of FrontByColour(), lx; empty without colour and in
  /// Method::FinalGathering.
  std::vector<std::array<double, 3>> ColourErrors() const;
  /// The light on the front from one luminaire with its own errors, where
  /// TraceSettings::lampsApart, in Method::PhotonTracing.
  IlluminationMap MapOfLamp(std::size_t lamp) const;
  /// [vertex] The light on the front from one luminaire, lx; 0 unless TraceSettings::lampsApart.
  std::vector<double> FrontOfLamp(std::size_t lamp) const;

  /// In Method::FinalGathering, the map on a surface that is refined where linear interpolation
  /// misses the light by more than the limits allow; see AdaptiveGathering. What photons have
  /// brought (caustics) is interpolated. Nothing if the second pass has not been done to its end,
  /// or if it was stopped before all points of a curved surface had light. Throws InvalidInput for
  /// limits out of range. @param surface That of the scene. @param monitor Called now and then from
  /// the calling thread with how many points have received light. If it returns false, the surface
  /// is refined as far as it was.
  std::optional<RefinedMap> Refine(const Surface& surface, const AdaptiveLimits& limits,
    const std::function<bool(std::uint64_t points)>& monitor = {});

  /// A photon map of the run: the hits of its first photons, of as many as have at most `most` hits
  /// together. If these are all photons, they are those that the map is of.
  StoredPhotons Photons(
    std::uint64_t most,
    const std::function<bool(std::uint64_t hits)>& goOn = [](std::uint64_t) { return true; }) const;
  /// The paths of the first photons.
  std::vector<PhotonPath> Paths(std::uint64_t photons) const;

  PhotonBalance Balance() const { return this->Sums.Balance(); }
  /// Where each luminaire's photons first arrived. [luminaire]
  std::vector<Arrivals> ArrivalsByLamp() const;
  /// The same in lm, of light that arrives anywhere: without Arrivals::elsewhere, where light is
  /// not counted or is counted twice.
  std::vector<ArrivedFlux> FluxArrivedByLamp() const;
  /// The same with the squared flux of each photon, lm^2; see ShareOfLight.
  std::vector<ArrivedFlux> SquaredFluxArrivedByLamp() const;
  /// Of the scattered light that met the surface, each time it did, what fell on backs. Where light
  /// comes in through openings, what the sky and the sun send outdoors is left out: there it meets
  /// the outsides of walls.
  ShareOfLight ScatteredLightOnBacks() const;
  /// The balance in lm. Light through openings counts in `emitted` twice, with the sky's that is
  /// handed over there and with what starts there.
  FluxBalance BalanceOfFlux() const;
  /// See PhotonTracer.
  std::optional<glm::uvec3> CornersLitFromBehind(std::size_t lamp) const
  {
    return this->Tracer.CornersLitFromBehind(static_cast<std::uint32_t>(lamp));
  }
  double Flux() const;                              ///< Of all lamps, lm.
  std::uint32_t LampOf(std::uint32_t source) const; ///< See Emitter.
  /// As photons were traced.
  const std::vector<float>& StartWeights() const { return this->Tracer.StartWeights(); }
  /// lm that a photon of a source stands for where so many photons stand for all light.
  double FluxOfPhoton(std::size_t source, std::uint64_t photons) const;
  double FluxOf(std::uint64_t photons) const; ///< lm that so many photons stand for on average.
  double FluxCutByWeightBound() const;        ///< lm
  /// The flux that an effect which is switched off would have carried on, lm.
  double FluxSwitchedOff(Scattering scattering) const;
  double Seconds() const { return this->SecondsTraced; }
  const Effects& EffectsInUse() const { return this->EffectsNow; }

  /// One row for each round; the last one is of the map as it is.
  const std::vector<Accuracy>& Rounds() const { return this->Rows; }

private:
  /// Blocks of photons that a replicate has traced.
  std::uint64_t BlocksOf(std::uint32_t replicate) const
  {
    return this->Sums.replicates[replicate].Balance().emitted / PhotonBlock;
  }
  /// Blocks of each replicate for at least so many photons in all.
  std::uint64_t BlocksFor(std::uint64_t photons) const
  {
    const std::uint64_t inOneOfEach = this->Sums.replicates.size() * PhotonBlock;
    return (photons + inOneOfEach - 1) / inOneOfEach;
  }
  MapScale Scale() const
  {
    return { this->LightFactor * this->Tracer.Flux(), this->LitScene.VertexAreas(),
      this->Tracer.StartWeights() };
  }
  IlluminationMap MapOf(ReplicateSums::Side side) const
  {
    return this->Sums.Map(side, this->Scale(), this->Factors);
  }
  double FactorOf(std::size_t source) const
  {
    return this->Factors.empty() ? 1.0 : this->Factors[source % this->Factors.size()];
  }
  std::vector<double> LampAlone(std::size_t lamp) const;
  LampFactors FactorsOfChannel(std::size_t channel) const;
  /// [vertex] A value of the maps of each channel, where lamps tell colours.
  std::vector<std::array<double, 3>> ColoursOfLamps(
    const std::function<double(const IlluminationMap& map, std::size_t vertex)>& value) const;
  double FluxOfPhoton(std::size_t source) const;
  std::vector<ArrivedFlux> ArrivedByLamp(
    const std::function<double(std::size_t source)>& ofPhoton) const;
  std::optional<StopReason> GatherRound(const StopRules& rules, const ProgressMonitor& monitor);
  std::uint64_t BlocksTraced() const { return this->Balance().emitted / PhotonBlock; }
  std::optional<StopReason> RuleReached(const StopRules& rules) const;
  std::uint64_t NextRound(const StopRules& rules) const;
  std::optional<StopReason> TraceRound(const StopRules& rules, const ProgressMonitor& monitor);
  std::optional<StopReason> TraceReplicate(std::uint32_t number, std::uint64_t end,
    const StopRules& rules, const ProgressMonitor& monitor);
  bool TraceSlice(std::uint32_t number, std::uint64_t first, std::uint64_t count,
    const StopRules& rules, const ProgressMonitor& monitor);
  /// Each rank's clock is its own.
  void AgreeOnTime() { this->SecondsTraced = this->Sharing->OfFirst(this->SecondsTraced); }
  void AddRow(const StopRules& rules);
  void MeasureErrorsOf(Accuracy& row) const;
  RunProgress ProgressOfGathering(const StopRules& rules, double done, double seconds);
  RunProgress ProgressTowards(const StopRules& rules, std::uint64_t blocksOfSlice);

  const Scene& LitScene;
  TraceSettings Settings;
  std::unique_ptr<const FacetCells> Cells; ///< By which the second pass knows the first; or null.
  PhotonTracer Tracer;
  Lighting Traced;          ///< As lamps were traced.
  Lighting Now;             ///< That of the map.
  Effects EffectsNow;       ///< The same.
  double LightFactor = 1.0; ///< Of the light of all lamps over that which was traced.
  LampFactors Factors;      ///< In addition, where lamps differ in it.
  bool HasOtherColours = false;
  std::unique_ptr<SecondPass> Second; ///< Null in Method::PhotonTracing.
  ReplicateSums Sums;
  IlluminationSums Part; ///< What this one of several ranks has traced since ranks last added up.
  std::vector<Accuracy> Rows;
  std::vector<double> RegionAreas; ///< [vertex] m^2; empty if there is no region.
  bool FacetsCount = false;        ///< In the last row.
  double SecondsTraced = 0.0;
  double LargestFraction = 0.0;
  bool WithoutGaps = true;
  Ranks Alone;
  Ranks* Sharing = &this->Alone;
};

} // namespace PhotonTransport
