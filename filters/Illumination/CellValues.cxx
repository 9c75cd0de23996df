// SPDX-License-Identifier: BSD-3-Clause
#include "CellValues.h"

#include "SceneBlocks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <sstream>

namespace
{

vtkDataArray* CheckedArray(const SceneBlock& block, const std::string& name)
{
  vtkAbstractArray* found = block.data->GetCellData()->GetAbstractArray(name.c_str());
  const std::string where = "cell array '" + name + "'" + block.name;
  if (!found)
  {
    const bool onPoints = block.data->GetPointData()->HasArray(name.c_str());
    throw InputError("there is no " + where +
      (onPoints ? "; there is a point array of that name, but values must be per cell" : ""));
  }
  auto* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    throw InputError(where + " is a " + found->GetClassName() + ", not numbers");
  }
  const int components = array->GetNumberOfComponents();
  if (components != 1 && components != 3)
  {
    throw InputError(
      where + " has " + std::to_string(components) + " components; 1 or 3 are wanted");
  }
  if (array->GetNumberOfTuples() != block.data->GetNumberOfCells())
  {
    throw InputError(where + " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(block.data->GetNumberOfCells()) + " cells");
  }
  return array;
}

} // namespace

CellValues::CellValues(
  const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind)
  : Array(CheckedArray(block, arrayName))
{
  for (const vtkIdType cell : block.cellOfFacet)
  {
    for (int c = 0; c < this->Array->GetNumberOfComponents(); ++c)
    {
      const double value = this->Array->GetComponent(cell, c);
      if (!(value >= 0.0 && value <= kind.largest)) // NaN too
      {
        std::ostringstream message;
        message << "cell " << cell << block.name << ": " << kind.what << " " << value
                << " in array '" << arrayName << "' is outside [0, " << kind.largest << "]";
        throw InputError(message.str());
      }
    }
  }
}

float CellValues::Of(vtkIdType cell) const
{
  if (!this->Array)
  {
    return static_cast<float>(this->Constant);
  }
  const int components = this->Array->GetNumberOfComponents();
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += this->Array->GetComponent(cell, c);
  }
  return static_cast<float>(sum / components);
}
