// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMap.h"

#include "CoreSettings.h"
#include "IlluminationArrays.h"
#include "LuminaireInput.h"
#include "MissingLight.h"
#include "OneRank.h"
#include "Pipeline.h"
#include "SceneBlocks.h"
#include "SceneWarnings.h"

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
#include "vtkTable.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <sstream>

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

/// Identity of a data object: a time stamp that no other state of any object has.
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

/// A run that the next execution may go on with.
struct vtkIlluminationMap::KeptRun
{
  KeptRun(vtkIlluminationMap* filter, const SceneBlocks& blocks,
    const PhotonTransport::Lighting& lighting, std::string shape)
    : Scene(blocks.Surface())
    , Run(this->Scene, lighting, SettingsOf(filter))
    , Shape(std::move(shape))
  {
  }

  bool Serves(const std::string& shape, vtkIdType photons) const
  {
    return this->Run.CanGoOn() && this->Shape == shape &&
      static_cast<vtkIdType>(this->Run.Balance().emitted) <= RoundedUp(photons);
  }

  static vtkIdType RoundedUp(vtkIdType photons)
  {
    constexpr vtkIdType Blocks = 2048; // as the core rounds: 8 replicates of 256
    return (photons + Blocks - 1) / Blocks * Blocks;
  }

  PhotonTransport::Scene Scene;
  PhotonTransport::IlluminationRun Run;
  std::string Shape; ///< See WhatShapesTheMap.
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
    this->Modified();
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
    this->Modified();
  }
}

/// Everything that the map depends on except the number of photons.
std::string vtkIlluminationMap::WhatShapesTheMap(vtkDataObject* input, const Luminaires& luminaires)
{
  std::ostringstream shape;
  shape.precision(17);
  const auto add = [&](const auto&... values) { ((shape << values << '|'), ...); };
  for (const LuminaireInput& luminaire : luminaires)
  {
    add(static_cast<const void*>(luminaire.data), LatestChange(luminaire.data));
  }
  add(this->SpecularReflectance, this->GlossyReflectance, this->DiffuseTransmittance,
    this->ClearTransmittance, this->Roughness, this->RefractiveIndex, this->SolidBody,
    this->UseMaterialArrays, this->SpecularReflection, this->GlossyReflection,
    this->DiffuseTransmission, this->ClearTransmission, this->Refraction, this->Colour,
    this->LampContributions);
  add(static_cast<const void*>(input), LatestChange(input), this->LampType, this->LampPosition[0],
    this->LampPosition[1], this->LampPosition[2], this->LampDirection[0], this->LampDirection[1],
    this->LampDirection[2], this->LampSize[0], this->LampSize[1], this->SpotHalfAngle,
    this->SpotExponent, this->LuminousFlux, this->ParallelIlluminance, this->Reflectance,
    this->ReflectanceArray, this->ExitanceArray, this->Registration, this->Seed, this->Sampling,
    this->Interreflection, this->RegisterBackSide, this->MetresPerUnit, this->FeatureAngle,
    this->NumberOfThreads, this->WeightBound, this->MaximumPathLength);
  return shape.str();
}

int vtkIlluminationMap::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    RequireSurfaces(info);
    return 1;
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
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, input, output);
  }
  if (!vtkTable::GetData(output, 1))
  {
    vtkNew<vtkTable> table;
    output->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), table);
  }
  return MakeOutputLikeInput(input, output) ? 1 : 0;
}

int vtkIlluminationMap::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // An observer may disconnect the input.
  const vtkSmartPointer<vtkDataObject> in = vtkDataObject::GetData(input[0]);
  vtkDataObject* out = vtkDataObject::GetData(output);
  PassThrough(in, out);
  const RankTask task = TaskOfThisRank(in, input[1]);
  if (!task.Works)
  {
    this->Kept.reset();
    FillAccuracyTable(vtkTable::GetData(output, 1), {});
    if (!task.Message.empty())
    {
      vtkErrorMacro(<< task.Message);
    }
    return 1;
  }
  // After an error the input is passed through and the pipeline stays usable. The error is reported
  // here; with a return value of 0 the executive would report a second one.
  try
  {
    this->Trace(in, LuminaireInputs(input[1]), out, vtkTable::GetData(output, 1));
  }
  catch (const std::bad_alloc&)
  {
    this->Kept.reset();
    PassThrough(in, out); // without the arrays of the map that were already added
    vtkErrorMacro("out of memory for an input of " << out->GetActualMemorySize() << " KiB");
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkIlluminationMap::Trace(
  vtkDataObject* input, const Luminaires& luminaires, vtkDataObject* output, vtkTable* accuracy)
{
  const SceneBlocks blocks(output, DescriptionOf(this, !luminaires.empty()));
  const PhotonTransport::Lighting lighting = LightingOf(this, luminaires);
  try
  {
    const PhotonTransport::StopRules rules = RulesOf(this);
    Validate(rules);
    const PhotonTransport::TraceSettings settings = SettingsOf(this);
    Validate(settings);
    const std::uint64_t forGroups = this->GroupMeans ? PhotonTransport::GroupMeansPerVertex : 0;
    const std::uint64_t need = PhotonTransport::MemoryNeed(blocks.Surface(), lighting, settings) +
      blocks.Surface().points.size() * forGroups;
    const std::uint64_t memoryLimit = MemoryLimitOf(this);
    const std::string shape = this->WhatShapesTheMap(input, luminaires);
    if (!this->Kept || !this->Kept->Serves(shape, this->Photons))
    {
      this->Kept.reset(); // first, so that two never share the memory
      PhotonTransport::RequireMemory(need, memoryLimit);
      const std::string text =
        "Building the scene, up to " + std::to_string(need >> 20) + " MiB of memory";
      this->SetProgressText(text.c_str());
      this->UpdateProgress(0.0);
      this->Kept = std::make_unique<KeptRun>(this, blocks, lighting, shape);
    }
    PhotonTransport::IlluminationRun& run = this->Kept->Run;
    const PhotonTransport::StopReason reason = run.Advance(rules,
      [report = ProgressReport(this)](const PhotonTransport::RunProgress& progress) mutable
      {
        return report(progress.fraction,
          "Tracing photons, " + std::to_string(std::lround(progress.secondsLeft)) + " s left");
      });

    AddPointArrays(blocks, this->Kept->Scene, run, this->RegisterBackSide);
    AddLayers(blocks, this->Kept->Scene, run, this->LampContributions ? &lighting : nullptr);
    if (this->GroupMeans)
    {
      AddGroupMeans(blocks, this->Kept->Scene, run);
    }
    const MissingLight missing = FindMissingLight(
      { blocks, lighting, run, this->RegisterBackSide, this->MetresPerUnit }, reason);
    std::vector<std::string> notes = NotesOn(blocks, this->Kept->Scene);
    notes.insert(notes.end(), missing.notes.begin(), missing.notes.end());
    const std::vector<std::string> onFiles = NotesOn(lighting);
    notes.insert(notes.end(), onFiles.begin(), onFiles.end());
    AddFieldData(output->GetFieldData(), run, reason, notes);
    AddMemoryNeeded(output->GetFieldData(), need);
    FillAccuracyTable(accuracy, run.Rounds());
    for (const std::string& warning : WarningsOn(blocks, this->Kept->Scene))
    {
      vtkWarningMacro(<< warning);
    }
    if (!missing.warning.empty())
    {
      vtkWarningMacro(<< missing.warning);
    }
  }
  catch (const InvalidInput& error)
  {
    throw InputError(Message(error, blocks));
  }
}

void vtkIlluminationMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [](const double* v)
  { return std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]); };
  os << indent << "LampType: " << this->LampType << "\n"
     << indent << "LampPosition: " << vector(this->LampPosition) << "\n"
     << indent << "LampDirection: " << vector(this->LampDirection) << "\n"
     << indent << "LampSize: " << this->LampSize[0] << ", " << this->LampSize[1] << "\n"
     << indent << "SpotHalfAngle: " << this->SpotHalfAngle << "\n"
     << indent << "SpotExponent: " << this->SpotExponent << "\n"
     << indent << "LuminousFlux: " << this->LuminousFlux << "\n"
     << indent << "ParallelIlluminance: " << this->ParallelIlluminance << "\n"
     << indent << "Reflectance: " << this->Reflectance << "\n"
     << indent << "SpecularReflectance: " << this->SpecularReflectance << "\n"
     << indent << "GlossyReflectance: " << this->GlossyReflectance << "\n"
     << indent << "Roughness: " << this->Roughness << "\n"
     << indent << "DiffuseTransmittance: " << this->DiffuseTransmittance << "\n"
     << indent << "ClearTransmittance: " << this->ClearTransmittance << "\n"
     << indent << "RefractiveIndex: " << this->RefractiveIndex << "\n"
     << indent << "SolidBody: " << this->SolidBody << "\n"
     << indent << "UseMaterialArrays: " << this->UseMaterialArrays << "\n"
     << indent << "ReflectanceArray: " << this->ReflectanceArray << "\n"
     << indent << "ExitanceArray: " << this->ExitanceArray << "\n"
     << indent << "Registration: " << this->Registration << "\n"
     << indent << "Photons: " << this->Photons << "\n"
     << indent << "TargetRelativeError: " << this->TargetRelativeError << "\n"
     << indent << "TimeLimit: " << this->TimeLimit << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Sampling: " << this->Sampling << "\n"
     << indent << "Interreflection: " << this->Interreflection << "\n"
     << indent << "SpecularReflection: " << this->SpecularReflection << "\n"
     << indent << "GlossyReflection: " << this->GlossyReflection << "\n"
     << indent << "DiffuseTransmission: " << this->DiffuseTransmission << "\n"
     << indent << "ClearTransmission: " << this->ClearTransmission << "\n"
     << indent << "Refraction: " << this->Refraction << "\n"
     << indent << "Colour: " << this->Colour << "\n"
     << indent << "LampContributions: " << this->LampContributions << "\n"
     << indent << "RegisterBackSide: " << this->RegisterBackSide << "\n"
     << indent << "GroupMeans: " << this->GroupMeans << "\n"
     << indent << "MetresPerUnit: " << this->MetresPerUnit << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n"
     << indent << "WeightBound: " << this->WeightBound << "\n"
     << indent << "MaximumPathLength: " << this->MaximumPathLength << "\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
