// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminanceSensors.h"

#include "vtkIlluminationMap.h"

#include "Illumination/luminaires/LuminaireInput.h"
#include "Illumination/luminaires/WholeLuminaires.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/WholeSurface.h"
#include "Illumination/sensors/GridMesh.h"
#include "Illumination/sensors/SensorArrays.h"
#include "Illumination/sensors/SensorInput.h"
#include "Illumination/sensors/SensorNotes.h"
#include "Illumination/sensors/SensorScene.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <sstream>

using namespace Illumination;

vtkStandardNewMacro(vtkIlluminanceSensors);

namespace
{

using PhotonTransport::InvalidInput;
using PhotonTransport::SensorDirections;
using PhotonTransport::SensorReading;

constexpr int LuminairePort = 1;
constexpr int SensorPort = 2;

/// Of the progress, the part of the photons.
constexpr double TracingShare = 0.4;

std::vector<PhotonTransport::AreaTriangle> BottomOf(
  const double bounds[6], vtkDataObject* surface, const glm::dvec3& up)
{
  glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  if (std::all_of(bounds, bounds + 6, [](double bound) { return bound == 0.0; }))
  {
    low = glm::dvec3(VTK_DOUBLE_MAX);
    high = -low;
    for (const auto& triangle : TrianglesOfAll(surface))
    {
      for (const glm::dvec3& corner : triangle)
      {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(low[axis] <= high[axis]) || !std::isfinite(high[axis] - low[axis])) // NaN too
    {
      std::ostringstream message;
      message << "GridBounds run from " << low[axis] << " to " << high[axis] << " along "
              << "xyz"[axis];
      throw InputError(message.str());
    }
  }
  return PhotonTransport::BottomOfBox(low, high, up);
}

} // namespace

vtkIlluminanceSensors::vtkIlluminanceSensors()
{
  this->SetNumberOfInputPorts(3);
}

void vtkIlluminanceSensors::AddLuminaireConnection(vtkAlgorithmOutput* luminaire)
{
  this->AddInputConnection(LuminairePort, luminaire);
}

void vtkIlluminanceSensors::RemoveAllLuminaires()
{
  this->RemoveAllInputConnections(LuminairePort);
}

void vtkIlluminanceSensors::SetSensorsConnection(vtkAlgorithmOutput* sensors)
{
  this->SetInputConnection(SensorPort, sensors);
}

int vtkIlluminanceSensors::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    return 1;
  }
  info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // errors name what does not serve
  info->Set(INPUT_IS_OPTIONAL(), 1);
  if (port == LuminairePort)
  {
    info->Set(INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkIlluminanceSensors::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkIlluminanceSensors::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, input, output);
  }
  if (this->Layout == POINTS && MakeOutputLikeInput(&input[SensorPort], output))
  {
    return 1;
  }
  if (!vtkPolyData::GetData(output))
  {
    vtkNew<vtkPolyData> grid;
    output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), grid);
  }
  return 1;
}

int vtkIlluminanceSensors::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* out = vtkDataObject::GetData(output);
  const vtkSmartPointer<vtkDataObject> points = vtkDataObject::GetData(input[SensorPort]);
  const auto empty = [&]
  {
    out->Initialize();
    if (this->Layout == POINTS && points)
    {
      PassThrough(points, out);
    }
  };
  empty();
  ControllerRanks ranks;
  const std::string error = ranks.Together([&] { this->ExecuteOnRanks(ranks, input, out); });
  if (!error.empty())
  {
    empty();
    if (ranks.Index() == 0)
    {
      vtkErrorMacro(<< error);
    }
  }
  return 1;
}

void vtkIlluminanceSensors::ExecuteOnRanks(
  ControllerRanks& ranks, vtkInformationVector** input, vtkDataObject* output)
{
  if (!ranks.AreSeveral())
  {
    this->Execute(ranks, input, output);
    return;
  }
  const auto whole = [&](int port)
  {
    auto ofAll = vtkSmartPointer<vtkInformationVector>::New();
    if (input[port]->GetNumberOfInformationObjects() > 0)
    {
      vtkNew<vtkInformation> information;
      information->Set(vtkDataObject::DATA_OBJECT(),
        WholeSurface(ranks, vtkDataObject::GetData(input[port])).Data());
      ofAll->Append(information);
    }
    return ofAll;
  };
  const auto surface = whole(0);
  const auto luminaires = WholeLuminaires(ranks, input[LuminairePort]);
  // Points stay on the ranks that have them. A grid lies over the polygons of all.
  const auto places = this->Layout == POLYGONS
    ? whole(SensorPort)
    : vtkSmartPointer<vtkInformationVector>(input[SensorPort]);
  vtkInformationVector* ofAll[] = { surface, luminaires, places };
  this->Execute(ranks, ofAll, output);
}

void vtkIlluminanceSensors::RequireRanges()
{
  const auto require = [](bool holds, const char* name, double value, const char* range)
  {
    if (!holds)
    {
      std::ostringstream message;
      message << name << " is " << value << "; it must be within " << range;
      throw InputError(message.str());
    }
  };
  require(this->Photons >= 1 && this->Photons <= 10000000000LL, "Photons",
    static_cast<double>(this->Photons), "[1, 1e10]");
  require(this->GatherRays >= static_cast<int>(PhotonTransport::LeastGatherRays) &&
      this->GatherRays <= static_cast<int>(PhotonTransport::MostGatherRays),
    "GatherRays", this->GatherRays, "[16, 16384]");
}

void vtkIlluminanceSensors::Execute(
  ControllerRanks& ranks, vtkInformationVector** inputs, vtkDataObject* output)
{
  this->RequireRanges();
  vtkDataObject* surface = vtkDataObject::GetData(inputs[0]);
  const std::vector<LuminaireInput> luminaires = LuminaireInputs(inputs[LuminairePort]);
  vtkNew<vtkIlluminationMap> map; // as the surface was lit
  bool ownLamp = false;
  if (!map->RecallSettings(surface->GetFieldData(), ownLamp))
  {
    throw InputError(
      "the input has no field array 'IlluminationMapSettings', which Illumination Map "
      "adds to its output: connect that, or what other filters have made of it");
  }
  if (luminaires.empty() && !ownLamp)
  {
    throw InputError("Luminaires lit the map, and none is connected here: connect them to "
                     "Luminaires of this filter as well");
  }
  map->SetSeed(this->Seed);
  map->SetNumberOfThreads(this->NumberOfThreads);
  const PhotonTransport::Lighting lighting = map->MakeLighting(luminaires);
  const SensorDirections directions = SensorDirections::From(
    { this->Up[0], this->Up[1], this->Up[2] }, vtkMath::RadiansFromDegrees(this->Azimuth));
  this->Place(ranks.Index(), inputs, directions, map->GetMetresPerUnit(), output);
  SensorInput input = SensorsOf(output, directions.up);
  ShareSensors(ranks, input);
  if (input.sensors.empty())
  {
    throw InputError("Sensors have no points");
  }
  const SceneBlocks blocks(surface, map->DescribeSurface(!luminaires.empty()));
  try
  {
    SensorScene scene(blocks.Surface(), lighting, map->MakeTraceSettings());
    scene.Run.ShareWith(ranks);
    std::vector<SensorReading> readings;
    if (!this->Measure(scene, input, directions, readings))
    {
      return;
    }
    std::string why;
    const std::optional<double> outdoors = OutdoorIlluminance(lighting, directions.up, why);
    AddSensorArrays(input.blocks, readings, outdoors, this->Azimuth);
    const SensorNotes said = NotesOn(scene, input, readings, lighting, why);
    AddArray(output->GetFieldData(), "Notes", said.notes);
    for (std::size_t i = 0; ranks.Index() == 0 && i < said.warnings.size(); ++i)
    {
      vtkWarningMacro(<< said.warnings[i]);
    }
  }
  catch (const InvalidInput& error)
  {
    throw InputError(blocks.WordsFor(error));
  }
}

void vtkIlluminanceSensors::Place(std::uint64_t rank, vtkInformationVector** inputs,
  const SensorDirections& directions, double metresPerUnit, vtkDataObject* output)
{
  vtkDataObject* given = inputs[SensorPort]->GetNumberOfInformationObjects() > 0
    ? vtkDataObject::GetData(inputs[SensorPort])
    : nullptr;
  if (this->Layout != BOX && !given)
  {
    throw InputError(this->Layout == POINTS
        ? "Layout is Points, and no data set with points is connected to Sensors"
        : "Layout is Grid over Polygons, and no polygons are connected to Sensors");
  }
  if (this->Layout != POINTS && rank == 0) // a grid is the first rank's
  {
    const PhotonTransport::GridSettings settings{ this->Height, this->Margin, this->Spacing,
      metresPerUnit };
    FillMesh(PhotonTransport::GridOver(this->Layout == BOX
                 ? BottomOf(this->GridBounds, vtkDataObject::GetData(inputs[0]), directions.up)
                 : TrianglesOfAll(given),
               directions, settings),
      vtkPolyData::SafeDownCast(output));
  }
}

bool vtkIlluminanceSensors::Measure(SensorScene& scene, const SensorInput& input,
  const SensorDirections& directions, std::vector<SensorReading>& readings)
{
  ProgressReport report(this);
  const auto tracing = [&](double done) { return report(TracingShare * done, "Tracing photons"); };
  const auto reading = [&](double done)
  { return report(TracingShare + (1.0 - TracingShare) * done, "Reading sensors"); };
  return scene.Run.Trace(static_cast<std::uint64_t>(this->Photons), tracing) &&
    scene.Run.Read(
      input.sensors, directions, static_cast<std::uint32_t>(this->GatherRays), reading, readings);
}

void vtkIlluminanceSensors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layout: " << this->Layout << "\n" << indent << "GridBounds:";
  for (const double bound : this->GridBounds)
  {
    os << " " << bound;
  }
  os << "\n"
     << indent << "Height: " << this->Height << "\n"
     << indent << "Margin: " << this->Margin << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "Up: " << this->Up[0] << " " << this->Up[1] << " " << this->Up[2] << "\n"
     << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Photons: " << this->Photons << "\n"
     << indent << "GatherRays: " << this->GatherRays << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
