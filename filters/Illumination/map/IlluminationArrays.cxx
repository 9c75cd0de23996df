// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/IlluminationArrays.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/map/MeshNotes.h"
#include "Illumination/map/PartArrays.h"
#include "Illumination/map/PointMapping.h"
#include "Illumination/map/RefinedScene.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/map/SceneWarnings.h"
#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/scene/Scene.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>

namespace Illumination
{
namespace
{

using PhotonTransport::IlluminationMap;
using PhotonTransport::IlluminationRun;

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

/// @param facetError [vertex] Or empty.
void AddFront(
  const PointMapping& mapping, const IlluminationMap& map, const std::vector<double>& facetError)
{
  vtkPointData* arrays = mapping.PointArrays();
  const std::vector<double> direct = mapping.Mean(map.direct);
  const std::vector<double> indirect = mapping.Mean(map.indirect);
  const std::vector<double> total = Sum(direct, indirect);
  const std::vector<double> error = mapping.MeanError(map.standardError);
  AddArray(arrays, "Illuminance", total);
  AddArray(arrays, "IlluminanceDirect", direct);
  AddArray(arrays, "IlluminanceIndirect", indirect);
  if (!map.caustic.empty())
  {
    AddArray(arrays, "IlluminanceCaustic", mapping.Mean(map.caustic));
  }
  AddArray(arrays, "StandardError", error);
  AddArray(arrays, "RelativeError", RelativeErrors(error, total));
  if (!facetError.empty())
  {
    AddArray(arrays, "FacetError", mapping.Mean(facetError));
  }
  if (map.caustic.empty()) // else hits tell of caustics alone
  {
    std::vector<std::uint64_t> hits(total.size(), 0);
    mapping.ForEach(
      [&](std::size_t vertex, std::size_t point) { hits[point] += map.photonHits[vertex]; });
    AddArray(arrays, "PhotonHits", hits);
  }
  arrays->SetActiveScalars("Illuminance");
}

void AddBack(const PointMapping& mapping, const IlluminationMap& map)
{
  AddArray(mapping.PointArrays(), "IlluminanceBack",
    Sum(mapping.Mean(map.direct), mapping.Mean(map.indirect)));
  AddArray(mapping.PointArrays(), "StandardErrorBack", mapping.MeanError(map.standardError));
}

void AddSides(const std::vector<PointMapping>& mappings, const IlluminationMap& front,
  const IlluminationMap& back, const std::vector<double>& facetError, bool backSide)
{
  for (const PointMapping& mapping : mappings)
  {
    AddFront(mapping, front, facetError);
    if (backSide)
    {
      AddBack(mapping, back);
    }
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
  const IlluminationMap front = run.Front();
  AddSides(mappings, front, wanted.backSide ? run.Back() : IlluminationMap(),
    run.FacetErrorOf(front), wanted.backSide);
  AddParts(mappings, run, front, wanted.ofLamps);
  if (wanted.groupMeans)
  {
    AddGroupMeans(mappings, run);
  }
}

void AddRefinedBlocks(const SceneBlocks& blocks, const PhotonTransport::Scene& scene,
  const PhotonTransport::RefinedMap& map, const WantedArrays& wanted)
{
  const std::vector<SceneBlock> refined = RefineBlocks(blocks, map.mesh);
  std::vector<double> weights = scene.VertexAreas();
  weights.resize(map.mesh.points.size(), 1.0); // no new point has more than one value
  std::vector<PointMapping> mappings;
  for (const SceneBlock& block : refined)
  {
    mappings.emplace_back(block, weights);
  }
  AddSides(mappings, map.front, map.back, {}, wanted.backSide);
  AddParts(mappings, map, wanted.ofLamps);
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
