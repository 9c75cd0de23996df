// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminaireInput.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/pipeline/InputError.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

namespace Illumination
{
namespace
{

vtkPolyData* RequirePolyData(vtkDataObject* data, const std::string& name)
{
  auto* polygonal = vtkPolyData::SafeDownCast(data);
  if (!polygonal)
  {
    throw InputError(name + " is none: it is a " +
      (data ? data->GetClassName() : "missing object") +
      ", and luminaires and surfaces that shine are vtkPolyData. Group Datasets puts several of "
      "them "
      "together, and Append Datasets and Merge Blocks do not");
  }
  return polygonal;
}

std::string BlockName(vtkCompositeDataIterator* it)
{
  std::string name = "block " + std::to_string(it->GetCurrentFlatIndex());
  const char* given =
    it->HasCurrentMetaData() ? it->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return given ? name + " '" + given + "'" : name;
}

/// As partitions are that hold nothing. A lamp whose source has an error is none: it says so.
bool IsEmpty(vtkPolyData* block)
{
  return block->GetNumberOfPoints() == 0 && !HasLuminaireFields(block->GetFieldData());
}

void AddBlocks(
  vtkCompositeDataSet* group, const std::string& name, std::vector<LuminaireInput>& inputs)
{
  const std::size_t before = inputs.size();
  auto it = vtk::TakeSmartPointer(group->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    const std::string blockName = name + ", " + BlockName(it);
    vtkPolyData* data = RequirePolyData(it->GetCurrentDataObject(), blockName);
    if (!IsEmpty(data))
    {
      inputs.push_back({ data, blockName });
    }
  }
  if (inputs.size() == before)
  {
    throw InputError(name + " is a group without any luminaire in it");
  }
}

} // namespace

std::vector<LuminaireInput> LuminaireInputs(vtkInformationVector* port)
{
  std::vector<LuminaireInput> inputs;
  for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* data = vtkDataObject::GetData(port, i);
    const std::string name = "luminaire " + std::to_string(i + 1);
    if (auto* group = vtkCompositeDataSet::SafeDownCast(data))
    {
      AddBlocks(group, name, inputs);
    }
    else
    {
      inputs.push_back({ RequirePolyData(data, name), name });
    }
  }
  return inputs;
}

} // namespace Illumination
