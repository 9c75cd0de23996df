// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/IlluminationArrays.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/map/EffectLines.h"
#include "Illumination/map/MeshNotes.h"
#include "Illumination/map/MissingLight.h"
#include "Illumination/map/PointMapping.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/map/SceneWarnings.h"
#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/scene/Scene.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <numeric>

namespace Illumination
{
namespace
{

using PhotonTransport::Accuracy;
using PhotonTransport::IlluminationMap;
using PhotonTransport::IlluminationRun;
using PhotonTransport::StopReason;

std::vector<double> Sum(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> sum(a.size());
  std::transform(a.begin(), a.end(), b.begin(), sum.begin(), std::plus<>());
  return sum;
}

/// 1 where no light has come, since nothing is known of it; 0 at a point without a triangle, where
/// none can come.
std::vector<double> RelativeErrors(
  const std::vector<double>& errors, const std::vector<double>& illuminance)
{
  std::vector<double> relative(errors.size());
  std::transform(errors.begin(), errors.end(), illuminance.begin(), relative.begin(),
    [](double error, double lux) { return lux > 0.0 ? error / lux : (error > 0.0 ? 1.0 : 0.0); });
  return relative;
}

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
    case StopReason::SumsFull:
      return "sums full: a point has had as many hits as its sum can hold";
    case StopReason::NothingLit:
      return "nothing lit: the target relative error can't be met";
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

void AddFront(const PointMapping& mapping, const IlluminationMap& map)
{
  vtkPointData* arrays = mapping.PointArrays();
  const std::vector<double> direct = mapping.Mean(map.direct);
  const std::vector<double> indirect = mapping.Mean(map.indirect);
  const std::vector<double> total = Sum(direct, indirect);
  const std::vector<double> error = mapping.MeanError(map.standardError);
  AddArray(arrays, "Illuminance", total);
  AddArray(arrays, "IlluminanceDirect", direct);
  AddArray(arrays, "IlluminanceIndirect", indirect);
  AddArray(arrays, "StandardError", error);
  AddArray(arrays, "RelativeError", RelativeErrors(error, total));
  std::vector<std::uint64_t> hits(total.size(), 0);
  mapping.ForEach(
    [&](std::size_t vertex, std::size_t point) { hits[point] += map.photonHits[vertex]; });
  AddArray(arrays, "PhotonHits", hits);
  arrays->SetActiveScalars("Illuminance");
}

void AddBack(const PointMapping& mapping, const IlluminationMap& map)
{
  AddArray(mapping.PointArrays(), "IlluminanceBack",
    Sum(mapping.Mean(map.direct), mapping.Mean(map.indirect)));
  AddArray(mapping.PointArrays(), "StandardErrorBack", mapping.MeanError(map.standardError));
}

void AddSides(const std::vector<PointMapping>& mappings, const IlluminationRun& run, bool backSide)
{
  const IlluminationMap front = run.Front();
  const IlluminationMap back = backSide ? run.Back() : IlluminationMap();
  for (const PointMapping& mapping : mappings)
  {
    AddFront(mapping, front);
    if (backSide)
    {
      AddBack(mapping, back);
    }
  }
}

template <typename Value>
void AddMean(const std::vector<PointMapping>& mappings, const std::string& name,
  const std::vector<Value>& values)
{
  for (const PointMapping& mapping : mappings)
  {
    AddArray(mapping.PointArrays(), name.c_str(), mapping.Mean(values));
  }
}

void AddLayers(const std::vector<PointMapping>& mappings, const IlluminationRun& run,
  const PhotonTransport::Lighting* lighting)
{
  if (run.EffectsInUse().colour)
  {
    AddMean(mappings, "IlluminanceRGB", run.FrontByColour());
  }
  for (std::size_t lamp = 0; lighting && lamp < lighting->luminaires.size(); ++lamp)
  {
    const std::string& name = lighting->luminaires[lamp].name;
    AddMean(mappings, "Illuminance_" + (name.empty() ? "Lamp" : name), run.FrontOfLamp(lamp));
  }
}

void AddGroupMeans(const std::vector<PointMapping>& mappings, const IlluminationRun& run)
{
  const PhotonTransport::GroupMeans groups = run.FrontByGroups();
  if (!groups.direct.empty()) // empty if the run ended before each group had a photon
  {
    AddMean(mappings, "IlluminanceDirectGroups", groups.direct);
    AddMean(mappings, "IlluminanceIndirectGroups", groups.indirect);
  }
}

} // namespace

void AddPointArrays(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const IlluminationRun& run, const WantedArrays& wanted)
{
  std::vector<PointMapping> mappings;
  for (const SceneBlock& block : blocks.Blocks())
  {
    mappings.emplace_back(block, scene.VertexAreas());
  }
  AddSides(mappings, run, wanted.backSide);
  AddLayers(mappings, run, wanted.ofLamps);
  if (wanted.groupMeans)
  {
    AddGroupMeans(mappings, run);
  }
}

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
  AddArray(output, "Effects", EffectLines(run.EffectsInUse(), switchedOff));
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
  column("Seconds", [](const Accuracy& row) { return row.seconds; });
  column("RelativeError", [](const Accuracy& row) { return row.relativeError; });
  column("MedianRelativeError", [](const Accuracy& row) { return row.medianRelativeError; });
  column(
    "Percentile95RelativeError", [](const Accuracy& row) { return row.percentile95RelativeError; });
  column("SegmentsPerSecond", [](const Accuracy& row) { return row.segmentsPerSecond; });
  column("PredictedPhotons", [](const Accuracy& row) { return row.predictedPhotons; });
  column("PredictedSeconds", [](const Accuracy& row) { return row.predictedSeconds; });
}

std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene)
{
  std::vector<std::string> notes = NotesOnMesh(blocks, scene.Notes());
  if (blocks.BlocksNotPolygonal() > 0)
  {
    notes.push_back(std::to_string(blocks.BlocksNotPolygonal()) +
      " blocks are not polygonal: they were passed through unlit and cast no shadow");
  }
  for (const SceneBlock& block : blocks.Blocks())
  {
    if (HasLuminaireFields(block.data->GetFieldData()))
    {
      notes.push_back("the surface" + block.name +
        " is, or was appended to, a luminaire: it stops light like any other surface, and shines "
        "only if it is connected to Luminaires");
    }
  }
  for (const std::vector<std::string>& lines :
    { NotesOnSharedPlaces(blocks, scene), WarningsOn(blocks, scene) })
  {
    notes.insert(notes.end(), lines.begin(), lines.end());
  }
  return notes;
}

std::vector<std::string> NotesOn(const PhotonTransport::Lighting& lighting)
{
  std::vector<std::string> notes;
  for (const PhotonTransport::Luminaire& luminaire : lighting.luminaires)
  {
    const auto onLamp =
      std::visit([&](const auto& lamp) { return lamp.Notes(luminaire.name); }, luminaire.lamp);
    notes.insert(notes.end(), onLamp.begin(), onLamp.end());
  }
  return notes;
}

} // namespace Illumination
