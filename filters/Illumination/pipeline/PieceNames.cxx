// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/pipeline/PieceNames.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace Illumination
{
namespace
{

std::string NameOf(const char* what, vtkIdType id, vtkFieldData* origins, const char* array,
  vtkPolyData* data, const std::string& block)
{
  auto* known = vtkIdTypeArray::SafeDownCast(origins->GetAbstractArray(array));
  auto* names = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(PieceNames));
  if (!known || !names || id >= known->GetNumberOfTuples())
  {
    return what + std::to_string(id) + block;
  }
  return what + std::to_string(known->GetTypedComponent(id, 1)) +
    names->GetValue(known->GetTypedComponent(id, 0));
}

} // namespace

std::string NameOfCell(vtkPolyData* data, vtkIdType cell, const std::string& block)
{
  return NameOf("cell ", cell, data->GetCellData(), CellOrigins, data, block);
}

std::string NameOfBlock(vtkPolyData* data, unsigned index)
{
  auto* name = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(BlockName));
  return name ? std::string(name->GetValue(0)) : " of block " + std::to_string(index);
}

std::string NameOfPoint(vtkPolyData* data, vtkIdType point, const std::string& block)
{
  return NameOf("point ", point, data->GetFieldData(), PointOrigins, data, block);
}

} // namespace Illumination
