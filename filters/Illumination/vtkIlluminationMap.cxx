// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMap.h"

#include "IlluminationArrays.h"
#include "SceneBlocks.h"
#include "VtkVersion.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/IlluminationMap.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <chrono>
#include <limits>
#include <new>

vtkStandardNewMacro(vtkIlluminationMap);

namespace
{

using PhotonTransport::InvalidInput;

glm::dvec3 Vector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

PhotonTransport::Lamp LampOf(vtkIlluminationMap* filter)
{
  const glm::dvec3 position = Vector(filter->GetLampPosition());
  const glm::dvec3 direction = Vector(filter->GetLampDirection());
  const double* size = filter->GetLampSize();
  const double flux = filter->GetLuminousFlux();
  switch (filter->GetLampType())
  {
    case vtkIlluminationMap::POINT:
      return PhotonTransport::PointLamp{ position, flux };
    case vtkIlluminationMap::LAMBERTIAN_POINT:
      return PhotonTransport::LambertianPointLamp{ position, direction, flux };
    case vtkIlluminationMap::SPOT:
      return PhotonTransport::SpotLamp{ position, direction,
        vtkMath::RadiansFromDegrees(filter->GetSpotHalfAngle()), filter->GetSpotExponent(), flux };
    case vtkIlluminationMap::RECTANGLE:
      return PhotonTransport::RectangleLamp{ position, direction, size[0], size[1], flux };
    case vtkIlluminationMap::DISK:
      return PhotonTransport::DiskLamp{ position, direction, size[0], flux };
    case vtkIlluminationMap::EMITTING_FACETS:
      return PhotonTransport::EmittingFacets{};
    default:
      return PhotonTransport::ParallelLight{ direction, filter->GetParallelIlluminance() };
  }
}

/// Negative numbers become 0, which the core refuses by name.
template <typename Unsigned, typename Signed>
Unsigned AtLeastZero(Signed value)
{
  return value > 0 ? static_cast<Unsigned>(value) : Unsigned{ 0 };
}

PhotonTransport::TraceSettings SettingsOf(vtkIlluminationMap* filter)
{
  PhotonTransport::TraceSettings settings;
  settings.photons = AtLeastZero<std::uint64_t>(filter->GetPhotons());
  settings.seed = static_cast<std::uint32_t>(filter->GetSeed());
  settings.sampling = static_cast<PhotonTransport::Sampling>(filter->GetSampling());
  settings.registration = static_cast<PhotonTransport::Registration>(filter->GetRegistration());
  settings.interreflection = filter->GetInterreflection();
  settings.registerBackSide = filter->GetRegisterBackSide();
  settings.weightBound = static_cast<float>(filter->GetWeightBound());
  settings.maximumPathLength = AtLeastZero<std::uint32_t>(filter->GetMaximumPathLength());
  settings.threads = filter->GetNumberOfThreads();
  return settings;
}

/// ParaView's lists of arrays send the word "None" for no array.
std::string ArrayName(const char* name)
{
  const std::string given = name ? name : "";
  return given == "None" ? "" : given;
}

SurfaceDescription DescriptionOf(vtkIlluminationMap* filter)
{
  SurfaceDescription description;
  description.reflectance = filter->GetReflectance();
  description.reflectanceArray = ArrayName(filter->GetReflectanceArray());
  if (filter->GetLampType() == vtkIlluminationMap::EMITTING_FACETS)
  {
    description.exitanceArray = ArrayName(filter->GetExitanceArray());
    if (description.exitanceArray.empty())
    {
      throw InputError("emitting facets need an ExitanceArray (lm/m^2 per cell); none is named");
    }
  }
  description.metresPerUnit = filter->GetMetresPerUnit();
  description.featureAngle = filter->GetFeatureAngle();
  return description;
}

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

/// Passes progress on, but not more often than a person can see.
class ProgressReport
{
public:
  explicit ProgressReport(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  /// Returns false once the user wants to stop.
  bool operator()(double fraction)
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - this->Last >= std::chrono::milliseconds(50))
    {
      this->Last = now;
      this->Algorithm->UpdateProgress(fraction);
    }
    return !AbortRequested(this->Algorithm);
  }

private:
  vtkAlgorithm* Algorithm;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

/// Makes the output refer to the input's data, block by block: arrays added to it stay its own.
void PassThrough(vtkDataObject* input, vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    return;
  }
  auto* result = vtkCompositeDataSet::SafeDownCast(output);
  result->CopyStructure(composite);
  result->GetFieldData()->PassData(composite->GetFieldData());
  auto it = vtk::TakeSmartPointer(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto block = vtk::TakeSmartPointer(it->GetCurrentDataObject()->NewInstance());
    block->ShallowCopy(it->GetCurrentDataObject());
    result->SetDataSet(it, block);
  }
}

} // namespace

vtkIlluminationMap::vtkIlluminationMap() = default;

int vtkIlluminationMap::FillInputPortInformation(int, vtkInformation* info)
{
  // Taking composite data itself keeps the pipeline from running the filter block by block: all
  // blocks shade each other and light each other.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkIlluminationMap::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkIlluminationMap::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, input, output);
  }
  vtkDataObject* in = vtkDataObject::GetData(input[0]);
  vtkDataObject* out = vtkDataObject::GetData(output);
  if (in && (!out || out->GetDataObjectType() != in->GetDataObjectType()))
  {
    auto fresh = vtk::TakeSmartPointer(in->NewInstance());
    output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return in ? 1 : 0;
}

int vtkIlluminationMap::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* out = vtkDataObject::GetData(output);
  PassThrough(vtkDataObject::GetData(input[0]), out);
  // An error leaves the input passed through and the pipeline usable: it is said once, here, and
  // not again by the executive, which a return value of 0 would bring about.
  try
  {
    this->Trace(out);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("out of memory for an input of " << out->GetActualMemorySize() << " KiB");
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkIlluminationMap::Trace(vtkDataObject* output)
{
  const SceneBlocks blocks(output, DescriptionOf(this));
  try
  {
    this->SetProgressText("Building the scene");
    this->UpdateProgress(0.0);
    const PhotonTransport::Scene scene(blocks.Surface());
    this->SetProgressText("Tracing photons");
    const PhotonTransport::IlluminationMap map = PhotonTransport::TraceIlluminationMap(
      scene, LampOf(this), SettingsOf(this), ProgressReport(this));

    for (const SceneBlock& block : blocks.Blocks())
    {
      AddPointArrays(block.data, block, scene, map);
    }
    AddFieldData(output->GetFieldData(), map, NotesOn(blocks, scene));
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
     << indent << "ReflectanceArray: " << this->ReflectanceArray << "\n"
     << indent << "ExitanceArray: " << this->ExitanceArray << "\n"
     << indent << "Registration: " << this->Registration << "\n"
     << indent << "Photons: " << this->Photons << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Sampling: " << this->Sampling << "\n"
     << indent << "Interreflection: " << this->Interreflection << "\n"
     << indent << "RegisterBackSide: " << this->RegisterBackSide << "\n"
     << indent << "MetresPerUnit: " << this->MetresPerUnit << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n"
     << indent << "WeightBound: " << this->WeightBound << "\n"
     << indent << "MaximumPathLength: " << this->MaximumPathLength << "\n";
}
