// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/PhotonArrays.h"

#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/pipeline/Text.h"

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/scene/HitPoint.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace Illumination
{
namespace
{

/// Of a photon's light, linear RGB with the luminance 1: white light has three equal components.
glm::dvec3 ColourOf(const PhotonTransport::PhotonHit& hit)
{
  return glm::dvec3(hit.shares) / glm::dvec3(PhotonTransport::LuminousWeights);
}

using PhotonTransport::PhotonHit;
using PhotonTransport::PhotonPath;

/// An array with a tuple for each hit. @param fill Called with a hit and where its tuple begins.
template <typename Array, typename Fill>
void AddHitArray(vtkPolyData* output, const char* name, int components,
  const std::vector<PhotonHit>& hits, const Fill& fill)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(hits.size()));
  auto* tuple = array->GetPointer(0);
  for (const PhotonHit& hit : hits)
  {
    fill(hit, tuple);
    tuple += components;
  }
  output->GetPointData()->AddArray(array);
}

/// Places in the data's coordinates.
class DataPlace
{
public:
  explicit DataPlace(const PhotonTransport::Scene& scene)
    : LitScene(scene)
    , Place(scene.GetPlacement())
  {
  }
  glm::dvec3 Of(const glm::vec3& point) const
  {
    return this->Place.centre + glm::dvec3(point) / this->Place.scale;
  }
  glm::dvec3 Of(const PhotonHit& hit) const
  {
    return this->Of(PointOf(this->LitScene, { hit.facet, hit.barycentric }));
  }
  /// A vector of a quarter of the scene's largest half extent, or more.
  glm::dvec3 Beyond(const glm::vec3& direction) const
  {
    constexpr double Length = 0.25;
    return glm::dvec3(direction) * (Length / this->Place.scale);
  }

private:
  const PhotonTransport::Scene& LitScene;
  const PhotonTransport::Placement& Place;
};

/// The cells of the input that facets of the scene are parts of.
class CellsOfHits
{
public:
  explicit CellsOfHits(const PhotonSource& source)
    : Source(source)
    , Blocks(source.blocks.Blocks())
  {
  }

  const SceneBlock& BlockOf(const PhotonHit& hit) const
  {
    const auto after =
      std::upper_bound(this->Blocks.begin(), this->Blocks.end(), this->FacetOf(hit),
        [](std::size_t facet, const SceneBlock& block) { return facet < block.firstFacet; });
    return *(after - 1);
  }
  vtkIdType CellOf(const PhotonHit& hit) const
  {
    const SceneBlock& block = this->BlockOf(hit);
    const vtkIdType cell = block.cellOfFacet[this->FacetOf(hit) - block.firstFacet];
    // Where ranks have put their pieces together, the number in the piece.
    vtkDataArray* origins = block.data->GetCellData()->GetArray(CellOrigins);
    return origins ? static_cast<vtkIdType>(origins->GetComponent(cell, 1)) : cell;
  }

private:
  std::size_t FacetOf(const PhotonHit& hit) const
  {
    return this->Source.scene.InSurface(hit.facet);
  }

  const PhotonSource& Source;
  const std::vector<SceneBlock>& Blocks;
};

void AddHitArrays(
  const PhotonSource& source, const PhotonTransport::StoredPhotons& stored, vtkPolyData* output)
{
  const std::vector<PhotonHit>& hits = stored.hits;
  const auto fluxOf = [&](const PhotonHit& hit)
  { return source.run.FluxOfPhoton(hit.source, stored.photons); };
  AddHitArray<vtkDoubleArray>(
    output, "Flux", 1, hits, [&](const PhotonHit& hit, double* value) { *value = fluxOf(hit); });
  AddHitArray<vtkFloatArray>(output, "Direction", 3, hits,
    [](const PhotonHit& hit, float* values)
    { std::copy(&hit.direction.x, &hit.direction.x + 3, values); });
  AddHitArray<vtkIntArray>(output, "Luminaire", 1, hits,
    [&](const PhotonHit& hit, int* value)
    { *value = static_cast<int>(source.run.LampOf(hit.source)); });
  AddHitArray<vtkIntArray>(output, "Scatterings", 1, hits,
    [](const PhotonHit& hit, int* value) { *value = static_cast<int>(hit.scatterings); });
  AddHitArray<vtkSignedCharArray>(output, "Side", 1, hits,
    [](const PhotonHit& hit, signed char* value) { *value = hit.front ? 1 : -1; });
  if (source.run.EffectsInUse().colour)
  {
    AddHitArray<vtkDoubleArray>(output, "FluxRGB", 3, hits,
      [&](const PhotonHit& hit, double* values)
      {
        const glm::dvec3 colour = ColourOf(hit);
        std::transform(
          &colour.x, &colour.x + 3, values, [&](double part) { return fluxOf(hit) * part; });
      });
  }
  const CellsOfHits cells(source);
  AddHitArray<vtkIdTypeArray>(output, "OriginalCellIds", 1, hits,
    [&](const PhotonHit& hit, vtkIdType* value) { *value = cells.CellOf(hit); });
  if (!source.blocks.Blocks().front().name.empty())
  {
    AddHitArray<vtkIntArray>(output, "BlockIndex", 1, hits,
      [&](const PhotonHit& hit, int* value)
      { *value = static_cast<int>(cells.BlockOf(hit).number); });
  }
}

std::vector<std::string> NamesOf(const PhotonTransport::Lighting& lighting)
{
  std::vector<std::string> names;
  for (const PhotonTransport::Luminaire& luminaire : lighting.luminaires)
  {
    names.push_back(luminaire.name.empty() ? "Lamp" : luminaire.name);
  }
  return names;
}

/// A vertex for each point.
void AddVertices(vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfTuples(output->GetNumberOfPoints() + 1);
  std::iota(
    offsets->GetPointer(0), offsets->GetPointer(0) + offsets->GetNumberOfTuples(), vtkIdType{ 0 });
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfTuples(output->GetNumberOfPoints());
  std::iota(
    points->GetPointer(0), points->GetPointer(0) + points->GetNumberOfTuples(), vtkIdType{ 0 });
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, points);
  output->SetVerts(vertices);
}

} // namespace

void RequirePhotonCounts(int most, int paths)
{
  if (most < 0)
  {
    throw InputError(Text("MaximumPhotons is ", most, "; it must be 0 or more"));
  }
  constexpr int MostPaths = 10000;
  if (paths < 0 || paths > MostPaths)
  {
    throw InputError(Text("PhotonPaths is ", paths, "; it must be from 0 to ", MostPaths));
  }
}

void FillPhotons(const PhotonSource& source, std::uint64_t most,
  const std::function<bool(std::uint64_t hits)>& goOn, vtkPolyData* output)
{
  output->Initialize();
  if (most == 0)
  {
    return;
  }
  const PhotonTransport::StoredPhotons stored = source.run.Photons(most, goOn);
  const DataPlace place(source.scene);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(stored.hits.size()));
  for (std::size_t i = 0; i < stored.hits.size(); ++i)
  {
    const glm::dvec3 point = place.Of(stored.hits[i]);
    points->SetPoint(static_cast<vtkIdType>(i), &point.x);
  }
  output->SetPoints(points);
  AddVertices(output);
  AddHitArrays(source, stored, output);
  AddArray(output->GetFieldData(), "PhotonsFollowed", std::vector<std::uint64_t>{ stored.photons });
  AddArray(output->GetFieldData(), "LuminaireNames", NamesOf(source.lighting));
}

void FillPhotonPaths(const PhotonSource& source, std::uint64_t photons, vtkPolyData* output)
{
  output->Initialize();
  if (photons == 0)
  {
    return;
  }
  const std::vector<PhotonPath> paths = source.run.Paths(photons);
  const DataPlace place(source.scene);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> scatterings;
  scatterings->SetName("Scatterings");
  const auto add = [&](const glm::dvec3& point, std::uint32_t number)
  {
    lines->InsertCellPoint(points->InsertNextPoint(&point.x));
    scatterings->InsertNextValue(static_cast<int>(number));
  };
  std::vector<std::uint64_t> luminaires;
  std::vector<std::uint64_t> escaped;
  std::vector<std::array<double, 3>> colours;
  for (const PhotonPath& path : paths)
  {
    lines->InsertNextCell(static_cast<int>(path.hits.size() + 1));
    glm::dvec3 last = place.Of(path.start.origin);
    add(last, 0);
    for (const PhotonHit& hit : path.hits)
    {
      last = hit.HasEscaped() ? last + place.Beyond(hit.direction) : place.Of(hit);
      add(last, hit.scatterings);
    }
    luminaires.push_back(source.run.LampOf(path.hits.front().source));
    const glm::dvec3 colour = ColourOf(path.hits.front());
    colours.push_back({ colour.x, colour.y, colour.z });
    escaped.push_back(path.hits.back().HasEscaped() ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(scatterings);
  AddArray(output->GetCellData(), "Luminaire", luminaires);
  AddArray(output->GetCellData(), "Escaped", escaped);
  if (source.run.EffectsInUse().colour)
  {
    AddArray(output->GetCellData(), "LightColour", colours);
  }
  AddArray(output->GetFieldData(), "LuminaireNames", NamesOf(source.lighting));
}

} // namespace Illumination
