// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/RunFacts.h"

#include "Illumination/map/EffectLines.h"
#include "Illumination/map/MissingLight.h"
#include "Illumination/pipeline/FieldArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace Illumination
{
namespace
{

using PhotonTransport::Accuracy;
using PhotonTransport::IlluminationRun;
using PhotonTransport::MapErrors;
using PhotonTransport::StopReason;

double PerSecond(std::uint64_t count, double seconds)
{
  return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

std::string NameOf(StopReason reason)
{
  switch (reason)
  {
    case StopReason::RelativeError:
      return "target relative error";
    case StopReason::TimeLimit:
      return "time limit";
    case StopReason::Abort:
      return "abort";
    case StopReason::Paused:
      return "nothing yet: the run goes on";
    case StopReason::SumsFull:
      return "sums full: a point has had as many hits as its sum can hold";
    case StopReason::NothingLit:
      return "nothing lit: the target relative error can't be met";
    case StopReason::FacetsTooLarge:
      return "facets too large for the target: FacetError alone is more; use Final Gathering, a "
             "finer mesh or a larger target";
    default:
      return "photon limit";
  }
}

/// [Scattering] What those that are switched off would have carried on, lm.
std::array<double, PhotonTransport::Scatterings> FluxSwitchedOff(const IlluminationRun& run)
{
  std::array<double, PhotonTransport::Scatterings> flux{};
  for (unsigned s = 0; s < PhotonTransport::Scatterings; ++s)
  {
    flux[s] = run.FluxSwitchedOff(static_cast<PhotonTransport::Scattering>(s));
  }
  return flux;
}

} // namespace

void AddFieldData(vtkFieldData* output, const IlluminationRun& run, StopReason reason,
  const std::vector<std::string>& notes)
{
  using Count = std::vector<std::uint64_t>;
  using Value = std::vector<double>;
  using Text = std::vector<std::string>;
  const PhotonTransport::PhotonBalance balance = run.Balance();
  const auto switchedOff = FluxSwitchedOff(run);
  AddArray(output, "PhotonsEmitted", Count{ balance.emitted });
  AddArray(output, "PhotonsAbsorbed", Count{ balance.absorbed });
  AddArray(output, "PhotonsEscaped", Count{ balance.escaped });
  AddArray(output, "PhotonsCutOff", Count{ balance.cutOff });
  AddArray(output, "PhotonsHandedOver", Count{ balance.handedOver });
  AddArray(output, "PhotonsBlocked", Count{ balance.blocked });
  AddArray(output, "EmittedFlux", Value{ run.Flux() });
  AddArrivals(output, run);
  AddArray(output, "FluxCutByWeightBound", Value{ run.FluxCutByWeightBound() });
  AddArray(output, "FluxSwitchedOff",
    Value{ std::accumulate(switchedOff.begin(), switchedOff.end(), 0.0) });
  AddArray(output, "Seconds", Value{ run.Seconds() });
  AddArray(output, "PhotonsPerSecond", Value{ PerSecond(balance.emitted, run.Seconds()) });
  AddArray(output, "SegmentsPerSecond", Value{ PerSecond(balance.segments, run.Seconds()) });
  if (!run.Rounds().empty() && run.Rounds().back().predictedPhotons > 0.0)
  {
    AddArray(output, "PredictedPhotons", Value{ run.Rounds().back().predictedPhotons });
    AddArray(output, "PredictedSeconds", Value{ run.Rounds().back().predictedSeconds });
  }
  AddArray(output, "StoppedBy", Text{ NameOf(reason) });
  AddArray(output, "Effects",
    EffectLines(
      run.EffectsInUse(), switchedOff, run.Rounds().empty() ? 0 : run.Rounds().back().gatherRays));
  AddArray(output, "Notes", notes);
  AddArray(output, "IlluminationMapsVersion", Text{ ILLUMINATION_VERSION });
}

void AddMemoryNeeded(vtkFieldData* output, std::uint64_t bytes)
{
  AddArray(output, "MemoryNeeded", std::vector<std::uint64_t>{ bytes });
}

void FillAccuracyTable(vtkTable* table, const std::vector<Accuracy>& rounds)
{
  const auto column = [&](const char* name, const auto& valueOf)
  {
    std::vector<double> values;
    values.reserve(rounds.size());
    std::transform(rounds.begin(), rounds.end(), std::back_inserter(values), valueOf);
    AddArray(table->GetRowData(), name, values);
  };
  table->Initialize();
  column("Photons", [](const Accuracy& row) { return static_cast<double>(row.photons); });
  column("GatherRays", [](const Accuracy& row) { return static_cast<double>(row.gatherRays); });
  column("Seconds", [](const Accuracy& row) { return row.seconds; });
  column("RelativeError", [](const Accuracy& row) { return row.relativeError; });
  column("RelativeFacetError", [](const Accuracy& row) { return row.relativeFacetError; });
  column("MedianRelativeError", [](const Accuracy& row) { return row.medianRelativeError; });
  column(
    "Percentile95RelativeError", [](const Accuracy& row) { return row.percentile95RelativeError; });
  column("SegmentsPerSecond", [](const Accuracy& row) { return row.segmentsPerSecond; });
  column("PredictedPhotons", [](const Accuracy& row) { return row.predictedPhotons; });
  column("PredictedSeconds", [](const Accuracy& row) { return row.predictedSeconds; });
  if (!rounds.empty() && rounds.back().region)
  {
    // Nothing is known of rounds before the region was chosen.
    const auto ofRegion = [](double MapErrors::*error)
    { return [=](const Accuracy& row) { return row.region ? (*row.region).*error : 1.0; }; };
    column("RegionRelativeError", ofRegion(&MapErrors::relativeError));
    column("RegionMedianRelativeError", ofRegion(&MapErrors::medianRelativeError));
    column("RegionPercentile95RelativeError", ofRegion(&MapErrors::percentile95RelativeError));
  }
}

} // namespace Illumination
