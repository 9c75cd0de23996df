// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMap.h"

#include "Illumination/luminaires/LuminaireInput.h"
#include "Illumination/map/IlluminationArrays.h"
#include "Illumination/map/LightLosses.h"
#include "Illumination/map/MissingLight.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/map/SceneWarnings.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"

#include "PhotonTransport/scene/CurvedSurface.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/MemoryNeed.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <new>

using namespace Illumination;

vtkStandardNewMacro(vtkIlluminationMap);

namespace
{

using PhotonTransport::InvalidInput;

/// The core's complaint with the user's name for the place.
std::string Message(const InvalidInput& error, const SceneBlocks& blocks)
{
  switch (error.Kind)
  {
    case InvalidInput::Where::Facet:
      return blocks.NameOfFacet(error.Index) + ": " + error.what();
    case InvalidInput::Where::Point:
      return blocks.NameOfVertex(error.Index) + ": " + error.what();
    default:
      return error.what();
  }
}

/// When data and filter last changed; no two states of any objects have the same time.
using Origins = std::vector<vtkMTimeType>;

vtkMTimeType LatestChange(vtkDataObject* data)
{
  vtkMTimeType latest = data->GetMTime();
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      latest = std::max(latest, it->GetCurrentDataObject()->GetMTime());
    }
  }
  return latest;
}

} // namespace

/// A run that the next execution may go on with, and what its map depends on but for the number of
/// photons.
struct vtkIlluminationMap::KeptRun
{
  KeptRun(const PhotonTransport::Surface& surface, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, Origins madeFrom, std::uint64_t memoryNeed)
    : Scene(surface)
    , Run(this->Scene, lighting, settings)
    , MadeFrom(std::move(madeFrom))
    , MemoryNeed(memoryNeed)
  {
  }

  PhotonTransport::Scene Scene;
  PhotonTransport::IlluminationRun Run;
  Origins MadeFrom;
  std::uint64_t MemoryNeed; ///< Without group means.
  double MemoryLimit = 0.0; ///< The property as it was, GiB.

  /// Whether another limit may allow more parts of curved patches.
  bool IsCoarseForAnother(double memoryLimit) const
  {
    return this->Scene.Notes().isCoarse && memoryLimit != this->MemoryLimit;
  }
};

vtkIlluminationMap::vtkIlluminationMap()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkIlluminationMap::~vtkIlluminationMap() = default;

void vtkIlluminationMap::Update(int port)
{
  const vtkSmartPointer<vtkIlluminationMap> alive(this);
  this->Superclass::Update(port);
}

void vtkIlluminationMap::SetPhotons(vtkIdType photons)
{
  if (photons != this->Photons || static_cast<double>(photons) != this->PhotonsAsDouble)
  {
    this->Photons = photons;
    this->PhotonsAsDouble = static_cast<double>(photons);
    this->Superclass::Modified();
  }
}

void vtkIlluminationMap::SetPhotonsAsDouble(double photons)
{
  constexpr double most = 0x1p62; // of what an integer can hold; a run takes 1e10
  this->SetPhotons(
    static_cast<vtkIdType>(std::isnan(photons) ? 0.0 : std::clamp(photons, -most, most)));
  if (static_cast<double>(this->Photons) != photons) // NaN too
  {
    this->PhotonsAsDouble = photons;
    this->Superclass::Modified();
  }
}

void vtkIlluminationMap::Modified()
{
  this->RunChanged.Modified();
  this->Superclass::Modified();
}

int vtkIlluminationMap::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  // Any data: a group arrives as a whole, and data that are no luminaire get an error that names
  // them.
  info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(INPUT_IS_OPTIONAL(), 1);
  info->Set(INPUT_IS_REPEATABLE(), 1);
  return 1;
}

void vtkIlluminationMap::AddLuminaireConnection(vtkAlgorithmOutput* luminaire)
{
  this->AddInputConnection(1, luminaire);
}

void vtkIlluminationMap::RemoveAllLuminaires()
{
  this->RemoveAllInputConnections(1);
}

int vtkIlluminationMap::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkTable");
  return 1;
}

int vtkIlluminationMap::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && !vtkTable::GetData(output, 1))
  {
    vtkNew<vtkTable> table;
    output->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), table);
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

void vtkIlluminationMap::WithoutResult(vtkInformationVector* outputs)
{
  FillAccuracyTable(vtkTable::GetData(outputs, 1), {});
}

void vtkIlluminationMap::Execute(
  vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const Luminaires luminaires = LuminaireInputs(inputs[1]);
  const SceneBlocks blocks(
    vtkDataObject::GetData(outputs), this->DescribeSurface(!luminaires.empty()));
  const PhotonTransport::Lighting lighting = this->MakeLighting(luminaires);
  Origins origins{ this->RunChanged, LatestChange(input) };
  for (const LuminaireInput& luminaire : luminaires)
  {
    origins.push_back(LatestChange(luminaire.data));
  }
  try
  {
    const PhotonTransport::StopRules rules = this->MakeStopRules();
    Validate(rules);
    const std::uint64_t need =
      this->PrepareRun(blocks, lighting, std::move(origins), rules.photons);
    const PhotonTransport::StopReason reason = this->Kept->Run.Advance(rules,
      [report = ProgressReport(this)](const PhotonTransport::RunProgress& progress) mutable
      {
        return report(progress.fraction,
          "Tracing photons, " + std::to_string(std::lround(progress.secondsLeft)) + " s left");
      });
    this->WriteMap(blocks, lighting, reason, outputs);
    AddMemoryNeeded(vtkDataObject::GetData(outputs)->GetFieldData(), need);
  }
  catch (const std::bad_alloc&)
  {
    this->Kept.reset();
    throw;
  }
  catch (const InvalidInput& error)
  {
    throw InputError(Message(error, blocks));
  }
}

std::uint64_t vtkIlluminationMap::PrepareRun(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, std::vector<vtkMTimeType> origins,
  std::uint64_t photons)
{
  const PhotonTransport::TraceSettings settings = this->MakeTraceSettings();
  Validate(settings);
  const std::uint64_t forGroups =
    this->GroupMeans ? blocks.Surface().points.size() * PhotonTransport::GroupMeansPerVertex : 0;
  const std::uint64_t memoryLimit = this->MemoryLimitInBytes();
  if (!this->Kept || this->Kept->MadeFrom != origins || !this->Kept->Run.CanGoOnTo(photons) ||
    this->Kept->IsCoarseForAnother(this->MemoryLimit))
  {
    this->Kept.reset(); // first, so that two never share the memory
    const PhotonTransport::Surface surface = this->CurvedSurface
      ? PhotonTransport::CurvedSurface(
          blocks.Surface(), PhotonTransport::MostRefinedFacets(memoryLimit))
      : blocks.Surface();
    const std::uint64_t needOfRun = PhotonTransport::MemoryNeed(surface, lighting, settings);
    const std::uint64_t need = needOfRun + forGroups;
    PhotonTransport::RequireMemory(need, memoryLimit);
    const std::string text =
      "Building the scene, up to " + std::to_string(need >> 20) + " MiB of memory";
    this->SetProgressText(text.c_str());
    this->UpdateProgress(0.0);
    this->Kept =
      std::make_unique<KeptRun>(surface, lighting, settings, std::move(origins), needOfRun);
    this->Kept->MemoryLimit = this->MemoryLimit;
  }
  return this->Kept->MemoryNeed + forGroups;
}

void vtkIlluminationMap::WriteMap(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, PhotonTransport::StopReason reason,
  vtkInformationVector* outputs)
{
  const PhotonTransport::IlluminationRun& run = this->Kept->Run;
  AddPointArrays(blocks, this->Kept->Scene, run,
    { this->RegisterBackSide, this->GroupMeans, this->LampContributions ? &lighting : nullptr });
  const MissingLight missing = FindMissingLight(
    { blocks, lighting, run, this->RegisterBackSide, this->MetresPerUnit }, reason);
  std::vector<std::string> notes = NotesOn(blocks, this->Kept->Scene);
  notes.insert(notes.end(), missing.notes.begin(), missing.notes.end());
  const std::vector<std::string> onFiles = NotesOn(lighting);
  notes.insert(notes.end(), onFiles.begin(), onFiles.end());
  AddFieldData(vtkDataObject::GetData(outputs)->GetFieldData(), run, reason, notes);
  FillAccuracyTable(vtkTable::GetData(outputs, 1), run.Rounds());
  for (const std::string& warning : WarningsOn(blocks, this->Kept->Scene))
  {
    vtkWarningMacro(<< warning);
  }
  if (!missing.warning.empty())
  {
    vtkWarningMacro(<< missing.warning);
  }
}
