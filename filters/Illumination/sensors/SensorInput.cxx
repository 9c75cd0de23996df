// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/sensors/SensorInput.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>

namespace Illumination
{
namespace
{

using PhotonTransport::Sensor;

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void Refuse(
  vtkIdType point, const SensorBlock& block, const char* what, const glm::dvec3& value)
{
  std::ostringstream message;
  message << "sensor " << point << block.name << ": its " << what << " is (" << value.x << ", "
          << value.y << ", " << value.z << ")";
  throw InputError(message.str());
}

/// One for each point; null if there are none and no polygons to make them from.
vtkSmartPointer<vtkDataArray> NormalsOf(const SensorBlock& block)
{
  if (vtkDataArray* given = block.data->GetPointData()->GetNormals())
  {
    return given;
  }
  auto* mesh = vtkPolyData::SafeDownCast(block.data);
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    return nullptr;
  }
  RequireValidCells(mesh, block.name);
  vtkNew<vtkPolyData> copy;
  copy->SetPoints(mesh->GetPoints());
  copy->SetPolys(mesh->GetPolys());
  copy->SetStrips(mesh->GetStrips());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(copy);
  normals->SplittingOff(); // which leaves the points as they are
  normals->ConsistencyOff();
  normals->Update();
  vtkDataArray* computed = normals->GetOutput()->GetPointData()->GetNormals();
  const bool isWhole = computed && computed->GetNumberOfTuples() == block.data->GetNumberOfPoints();
  return isWhole ? computed : nullptr;
}

void AddSensors(const SensorBlock& block, const glm::dvec3& up, SensorInput& input)
{
  const vtkSmartPointer<vtkDataArray> normals = NormalsOf(block);
  const bool given = block.data->GetPointData()->GetNormals() != nullptr;
  for (vtkIdType p = 0; p < block.data->GetNumberOfPoints(); ++p)
  {
    Sensor sensor{ {}, up };
    block.data->GetPoint(p, &sensor.position.x);
    if (!IsFinite(sensor.position))
    {
      Refuse(p, block, "place", sensor.position);
    }
    glm::dvec3 normal(0.0);
    if (normals)
    {
      normals->GetTuple(p, &normal.x);
    }
    const double length = glm::length(normal);
    if (length > 0.0 && IsFinite(normal))
    {
      sensor.normal = normal / length;
    }
    else if (given)
    {
      Refuse(p, block, "normal", normal);
    }
    else
    {
      ++input.withoutNormals; // a point that no polygon has is one, too
    }
    input.sensors.push_back(sensor);
  }
}

void Add(vtkDataObject* data, const std::string& name, const glm::dvec3& up, SensorInput& input)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    input.blocks.push_back({ set, name, input.sensors.size() });
    AddSensors(input.blocks.back(), up, input);
  }
}

} // namespace

SensorInput SensorsOf(vtkDataObject* data, const glm::dvec3& up)
{
  SensorInput input;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      Add(it->GetCurrentDataObject(), " of block " + std::to_string(it->GetCurrentFlatIndex()), up,
        input);
    }
  }
  else
  {
    Add(data, "", up, input);
  }
  return input;
}

void ShareSensors(ControllerRanks& ranks, SensorInput& input)
{
  const std::vector<std::vector<Sensor>> ofRanks = ranks.GatherValues(input.sensors);
  input.sensors.clear();
  for (std::size_t rank = 0; rank < ofRanks.size(); ++rank)
  {
    for (SensorBlock& block : input.blocks)
    {
      block.first += rank == ranks.Index() ? input.sensors.size() : 0;
    }
    input.sensors.insert(input.sensors.end(), ofRanks[rank].begin(), ofRanks[rank].end());
  }
  ranks.SumOne(input.withoutNormals);
}

} // namespace Illumination
