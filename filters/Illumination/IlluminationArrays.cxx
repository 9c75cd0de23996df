// SPDX-License-Identifier: BSD-3-Clause
#include "IlluminationArrays.h"

#include "FieldArrays.h"
#include "LuminaireFields.h"
#include "MissingLight.h"
#include "PointMapping.h"
#include "SceneBlocks.h"

#include "PhotonTransport/scene/Scene.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>

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

/// Where no light has come, nothing of it is known: 1. Where none can come, at a point without a
/// triangle, there is no error: 0.
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

double FluxSwitchedOff(const IlluminationRun& run)
{
  double flux = 0.0;
  for (unsigned s = 0; s < PhotonTransport::Scatterings; ++s)
  {
    flux += run.FluxSwitchedOff(static_cast<PhotonTransport::Scattering>(s));
  }
  return flux;
}

/// Why effects are on or off, and what those that were switched off would have carried.
std::vector<std::string> EffectLines(const IlluminationRun& run)
{
  std::vector<std::string> lines = run.EffectsInUse().reasons;
  for (unsigned s = 0; s < PhotonTransport::Scatterings; ++s)
  {
    const auto scattering = static_cast<PhotonTransport::Scattering>(s);
    const double flux = run.FluxSwitchedOff(scattering);
    const std::string start = EffectName(scattering) + ":";
    for (std::string& line : lines)
    {
      if (flux > 0.0 && line.rfind(start, 0) == 0)
      {
        std::ostringstream text;
        text << line << ", " << flux << " lm";
        line = text.str();
      }
    }
  }
  return lines;
}

void AddFront(vtkPointData* arrays, const PointMapping& mapping, const IlluminationMap& map)
{
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

std::string ThinGapsNote(const PhotonTransport::ThinGaps& gaps, const SceneBlocks& blocks)
{
  std::ostringstream text;
  text << "light may pass " << gaps.number
       << " triangles unseen, since another one is too close in front: "
       << blocks.NameOfFacet(gaps.facet) << " and " << blocks.NameOfFacet(gaps.other) << " are "
       << gaps.gap << " apart, and light that leaves a surface there starts " << gaps.offset
       << " away from it, because coordinates are no finer so far from the scene's finest part. "
          "Light that part in a run of its own, without what is far away, or close the gap";
  return text.str();
}

void AddBack(vtkPointData* arrays, const PointMapping& mapping, const IlluminationMap& map)
{
  AddArray(arrays, "IlluminanceBack", Sum(mapping.Mean(map.direct), mapping.Mean(map.indirect)));
  AddArray(arrays, "StandardErrorBack", mapping.MeanError(map.standardError));
}

} // namespace

void AddPointArrays(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const IlluminationRun& run, bool backSide)
{
  const IlluminationMap front = run.Front();
  const IlluminationMap back = backSide ? run.Back() : IlluminationMap();
  for (const SceneBlock& block : blocks.Blocks())
  {
    const PointMapping mapping(block, scene.VertexAreas(), block.data->GetNumberOfPoints());
    AddFront(block.data->GetPointData(), mapping, front);
    if (backSide)
    {
      AddBack(block.data->GetPointData(), mapping, back);
    }
  }
}

void AddLayers(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run, const PhotonTransport::Lighting* lighting)
{
  const auto add = [&](const std::string& name, const auto& values)
  {
    for (const SceneBlock& block : blocks.Blocks())
    {
      const PointMapping mapping(block, scene.VertexAreas(), block.data->GetNumberOfPoints());
      AddArray(block.data->GetPointData(), name.c_str(), mapping.Mean(values));
    }
  };
  if (run.EffectsInUse().colour)
  {
    add("IlluminanceRGB", run.FrontByColour());
  }
  for (std::size_t lamp = 0; lighting && lamp < lighting->luminaires.size(); ++lamp)
  {
    const std::string& name = lighting->luminaires[lamp].name;
    add("Illuminance_" + (name.empty() ? "Lamp" : name), run.FrontOfLamp(lamp));
  }
}

void AddGroupMeans(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::IlluminationRun& run)
{
  const PhotonTransport::GroupMeans groups = run.FrontByGroups();
  if (groups.direct.empty())
  {
    return; // ended before each group had a photon
  }
  for (const SceneBlock& block : blocks.Blocks())
  {
    const PointMapping mapping(block, scene.VertexAreas(), block.data->GetNumberOfPoints());
    AddArray(block.data->GetPointData(), "IlluminanceDirectGroups", mapping.Mean(groups.direct));
    AddArray(
      block.data->GetPointData(), "IlluminanceIndirectGroups", mapping.Mean(groups.indirect));
  }
}

void AddFieldData(vtkFieldData* output, const IlluminationRun& run, StopReason reason,
  const std::vector<std::string>& notes)
{
  using Count = std::vector<std::uint64_t>;
  using Value = std::vector<double>;
  using Text = std::vector<std::string>;
  const PhotonTransport::PhotonBalance balance = run.Balance();
  AddArray(output, "PhotonsEmitted", Count{ balance.emitted });
  AddArray(output, "PhotonsAbsorbed", Count{ balance.absorbed });
  AddArray(output, "PhotonsEscaped", Count{ balance.escaped });
  AddArray(output, "PhotonsCutOff", Count{ balance.cutOff });
  AddArray(output, "EmittedFlux", Value{ run.Flux() });
  AddArrivals(output, run);
  AddArray(output, "FluxCutByWeightBound", Value{ run.FluxCutByWeightBound() });
  AddArray(output, "FluxSwitchedOff", Value{ FluxSwitchedOff(run) });
  AddArray(output, "Seconds", Value{ run.Seconds() });
  AddArray(output, "PhotonsPerSecond", Value{ PerSecond(balance.emitted, run.Seconds()) });
  AddArray(output, "SegmentsPerSecond", Value{ PerSecond(balance.segments, run.Seconds()) });
  if (!run.Rounds().empty() && run.Rounds().back().predictedPhotons > 0.0)
  {
    AddArray(output, "PredictedPhotons", Value{ run.Rounds().back().predictedPhotons });
    AddArray(output, "PredictedSeconds", Value{ run.Rounds().back().predictedSeconds });
  }
  AddArray(output, "StoppedBy", Text{ NameOf(reason) });
  AddArray(output, "Effects", EffectLines(run));
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

namespace
{

/// "12 triangles WHAT, such as those of cell 3 and cell 7 (on 0.5 m^2): WHY"; nothing if there are
/// none.
void AddSharedPlaces(std::vector<std::string>& lines, const SceneBlocks& blocks,
  const PhotonTransport::SharedPlaceNote& note, const std::string& what, const std::string& why)
{
  if (note.facets > 0)
  {
    std::ostringstream line;
    line << note.facets << (note.facets == 1 ? " triangle " : " triangles ") << what
         << ", such as those of " << blocks.NameOfFacet(note.first) << " and "
         << blocks.NameOfFacet(note.second) << " (on " << note.squareMetres << " m^2): " << why;
    lines.push_back(line.str());
  }
}

} // namespace

std::vector<std::string> WarningsOnSharedPlaces(
  const SceneBlocks& blocks, const PhotonTransport::Scene& scene)
{
  const PhotonTransport::SharedPlaceNotes& found = scene.Notes().sharedPlaces;
  std::vector<std::string> warnings;
  AddSharedPlaces(warnings, blocks, found.unlikeMaterials,
    "lie in the place of others that face the same way and have another material",
    "the material of the later cell counts there. Remove one of the two, or move it");
  AddSharedPlaces(warnings, blocks, found.shineToo,
    "shine where others shine that face the same way",
    "the light of both is emitted there. Remove one of the two, or set its exitance to 0");
  return warnings;
}

std::vector<std::string> NotesOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene)
{
  std::vector<std::string> notes;
  for (const SceneBlock& block : blocks.Blocks())
  {
    if (block.normalsWereComputed)
    {
      notes.push_back("the points" + block.name + " had no normals; they were computed");
    }
    if (HasLuminaireFields(block.data->GetFieldData()))
    {
      notes.push_back("the surface" + block.name +
        " is, or was appended to, a luminaire: it stops light like any other surface, and shines "
        "only if it is connected to Luminaires");
    }
    if (block.uncut.number > 0)
    {
      notes.push_back(std::to_string(block.uncut.number) + " polygons, the first being cell " +
        std::to_string(block.uncut.first) + block.name +
        ", cross or touch themselves or have no area: they were left out, at least in part");
    }
  }
  const auto count = [&](std::size_t number, const std::string& what)
  {
    if (number > 0)
    {
      notes.push_back(std::to_string(number) + " " + what);
    }
  };
  const PhotonTransport::SceneNotes& found = scene.Notes();
  count(found.replacedNormals,
    "point normals were zero or not finite; the mean of the facets around the point stands in");
  count(found.turnedFacets,
    "triangles wind against their point normals; the normals decide which side is the front");
  count(found.droppedFacets, "triangles have no area and were left out");
  if (found.thinGaps.unresolved > 0)
  {
    notes.push_back(std::to_string(found.thinGaps.unresolved) + " triangles, the first being of " +
      blocks.NameOfFacet(found.thinGaps.firstUnresolved) +
      ", are too small for coordinates so far from the scene's finest part: light there is not "
      "right. Light that part in a run of its own, without what is far away");
  }
  if (found.thinGaps.number > 0)
  {
    notes.push_back(ThinGapsNote(found.thinGaps, blocks));
  }
  const PhotonTransport::SharedPlaceNotes& shared = found.sharedPlaces;
  AddSharedPlaces(notes, blocks, shared.copies,
    "are copies of others, with the same corners and facing the same way",
    "they count once, and the points of all copies get the whole light");
  AddSharedPlaces(notes, blocks, shared.inPart,
    "overlap others in their plane that face the same way",
    "each gets the whole light, and the material of the later cell counts");
  for (const std::string& warning : WarningsOnSharedPlaces(blocks, scene))
  {
    notes.push_back(warning);
  }
  count(blocks.BlocksNotPolygonal(), "blocks are not polygonal and were passed through unlit");
  return notes;
}

std::vector<std::string> NotesOn(const PhotonTransport::Lighting& lighting)
{
  std::vector<std::string> notes;
  for (const PhotonTransport::Luminaire& luminaire : lighting.luminaires)
  {
    if (const auto* lamp = std::get_if<PhotonTransport::PhotometricLamp>(&luminaire.lamp))
    {
      std::transform(lamp->solid.notes.begin(), lamp->solid.notes.end(), std::back_inserter(notes),
        [&](const std::string& note)
        { return "photometric file of luminaire '" + luminaire.name + "', " + note; });
    }
  }
  return notes;
}
