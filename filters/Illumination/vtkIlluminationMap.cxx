// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMap.h"

#include "Illumination/luminaires/LuminaireCache.h"
#include "Illumination/luminaires/LuminaireInput.h"
#include "Illumination/map/AccuracyRegion.h"
#include "Illumination/map/KeptRun.h"
#include "Illumination/map/MemoryOfOutputs.h"
#include "Illumination/map/PhotonArrays.h"
#include "Illumination/map/RunFacts.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"

#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/scene/CurvedSurface.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/MemoryBudget.h"

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

vtkIlluminationMap::vtkIlluminationMap()
  : LampsRead(std::make_unique<LuminaireCache>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkIlluminationMap::~vtkIlluminationMap() = default;

void vtkIlluminationMap::Update(int port)
{
  const vtkSmartPointer<vtkIlluminationMap> alive(this);
  this->Superclass::Update(port);
}

void vtkIlluminationMap::SetAccuracyRegionArray(const char* name)
{
  this->SetAndKeepRun(this->AccuracyRegionArray, std::string(name ? name : ""));
}

void vtkIlluminationMap::AddAccuracyRegionBlock(int flatIndex)
{
  if (this->AccuracyRegionBlocks.insert(flatIndex).second)
  {
    this->Superclass::Modified(); // the run goes on
  }
}

void vtkIlluminationMap::RemoveAllAccuracyRegionBlocks()
{
  this->SetAndKeepRun(this->AccuracyRegionBlocks, std::set<int>());
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
  constexpr const char* Types[] = { "vtkDataObject", "vtkTable", "vtkPolyData", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), Types[port]);
  return 1;
}

int vtkIlluminationMap::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && !vtkTable::GetData(output, 1))
  {
    output->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
    output->GetInformationObject(2)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
    output->GetInformationObject(3)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

void vtkIlluminationMap::WithoutResult(vtkInformationVector* outputs)
{
  FillAccuracyTable(vtkTable::GetData(outputs, 1), {});
  vtkPolyData::GetData(outputs, 2)->Initialize();
  vtkPolyData::GetData(outputs, 3)->Initialize();
}

void vtkIlluminationMap::Execute(
  vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const Luminaires luminaires = LuminaireInputs(inputs[1]);
  // The number stands for whether there is an own lamp, which the surface may be.
  Origins origins{ this->RunChanged, LatestChange(input), luminaires.empty() ? 0u : 1u };
  const std::shared_ptr<SceneBlocks> sceneBlocks =
    this->BlocksOf(vtkDataObject::GetData(outputs), origins);
  const SceneBlocks& blocks = *sceneBlocks;
  const PhotonTransport::Lighting lighting = this->MakeLighting(luminaires);
  try
  {
    this->StopBackground();
    const PhotonTransport::StopRules rules = this->MakeStopRules();
    Validate(rules);
    const std::vector<double> region = AccuracyRegion(blocks, vtkDataObject::GetData(outputs),
      { ArrayName(this->AccuracyRegionArray), this->AccuracyRegionBlocks });
    this->MakeAdaptiveLimits(); // which refuses bad ones before the run
    RequirePhotonCounts(this->MaximumPhotons, this->PhotonPaths);
    this->PrepareRun(blocks, lighting, std::move(origins), rules.photons);
    this->Kept->Blocks = sceneBlocks;
    this->Kept->Run.SetRegion(region);
    const PhotonTransport::StopReason reason = this->AdvanceRun(rules, region);
    this->WriteMap(blocks, lighting, reason, outputs);
    this->WritePhotons(blocks, lighting, outputs);
    AddMemoryNeeded(vtkDataObject::GetData(outputs)->GetFieldData(), this->Kept->Memory.Bytes());
    if (reason == PhotonTransport::StopReason::Paused)
    {
      this->StartBackground(rules);
    }
  }
  catch (const InvalidInput& error)
  {
    if (this->Kept && !this->Kept->Memory.IsKept())
    {
      this->Kept.reset(); // so that another limit counts
    }
    throw InputError(blocks.WordsFor(error));
  }
  catch (...) // out of memory, or another rank has failed
  {
    this->Kept.reset();
    throw;
  }
}

std::shared_ptr<SceneBlocks> vtkIlluminationMap::BlocksOf(
  vtkDataObject* output, const std::vector<vtkMTimeType>& origins)
{
  // Data that are the same on this rank may be put together with others.
  if (this->Kept && this->Kept->Blocks && this->Kept->MadeFrom == origins &&
    !this->GetRanks().AreSeveral())
  {
    this->Kept->Blocks->LieIn(output);
    return this->Kept->Blocks;
  }
  return std::make_shared<SceneBlocks>(output, this->DescribeSurface(origins.back() != 0));
}

void vtkIlluminationMap::PrepareRun(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, std::vector<vtkMTimeType> origins,
  std::uint64_t photons)
{
  const PhotonTransport::TraceSettings settings = this->MakeTraceSettings();
  Validate(settings);
  this->MemoryLimitInBytes(); // which refuses a bad one
  const bool storesPhotons = this->MaximumPhotons > 0 || this->PhotonPaths > 0;
  const bool goesOn = this->Kept && this->Kept->MadeFrom == origins &&
    this->Kept->Run.CanGoOnTo(photons) && !this->Kept->IsCoarseForAnother(this->MemoryLimit) &&
    this->Kept->Run.Relight(lighting) &&
    !(storesPhotons && this->Kept->Run.HasOtherColoursThanPhotons());
  if (this->GetRanks().Any(!goesOn)) // ranks may each have their own reason
  {
    this->Kept.reset(); // first, so that two never share the memory
    this->MakeRun(blocks, lighting, settings, std::move(origins));
  }
  const PhotonTransport::Surface& curved = this->Kept->Curved;
  this->Kept->Memory.SetBeside(MemoryOfOutputs(curved.IsRefined() ? curved : blocks.Surface(),
    lighting, settings, this->Kept->Memory.OfRun().HasColours(),
    { this->GroupMeans, static_cast<std::uint64_t>(this->MaximumPhotons) }));
}

void vtkIlluminationMap::MakeRun(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  std::vector<vtkMTimeType> origins)
{
  const std::uint64_t memoryLimit = this->MemoryLimitInBytes();
  PhotonTransport::Surface curved;
  if (this->CurvedSurface)
  {
    curved = PhotonTransport::CurvedSurface(
      blocks.Surface(), this->GetRanks().Least(PhotonTransport::MostRefinedFacets(memoryLimit)));
  }
  const PhotonTransport::Surface& surface = this->CurvedSurface ? curved : blocks.Surface();
  PhotonTransport::TraceSettings ofMemory = settings;
  if (this->GetRanks().AreSeveral()) // which keep what is not yet added up, as a thread does
  {
    ofMemory.threads = PhotonTransport::ThreadCount(settings.threads) + 1;
  }
  const PhotonTransport::MemoryNeed need(surface, lighting, ofMemory);
  const PhotonTransport::MemoryBudget memory(need,
    MemoryOfOutputs(surface, lighting, settings, need.HasColours(),
      { this->GroupMeans, static_cast<std::uint64_t>(this->MaximumPhotons) }),
    PhotonTransport::MemoryLimit(memoryLimit));
  const std::string text =
    "Building the scene, up to " + std::to_string(memory.Bytes() >> 20) + " MiB of memory";
  this->SetProgressText(text.c_str());
  this->UpdateProgress(0.0);
  this->Kept = std::make_unique<KeptRun>(surface, lighting, settings, std::move(origins), memory);
  this->Kept->MemoryLimit = this->MemoryLimit;
  if (surface.IsRefined())
  {
    this->Kept->Curved = std::move(curved);
  }
}
