// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/GhostCells.h"

#include "Illumination/pipeline/InputError.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace Illumination
{
namespace
{

vtkUnsignedCharArray* FlagsIn(
  vtkDataSetAttributes* arrays, vtkIdType wanted, const char* kind, const std::string& block)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* flags = vtkUnsignedCharArray::SafeDownCast(arrays->GetAbstractArray(name));
  if (flags && (flags->GetNumberOfComponents() != 1 || flags->GetNumberOfTuples() != wanted))
  {
    throw InputError(std::string(kind) + " array '" + name + "'" + block + " has " +
      std::to_string(flags->GetNumberOfValues()) + " values for " + std::to_string(wanted) + " " +
      kind + "s");
  }
  return flags;
}

} // namespace

GhostCells::GhostCells(vtkPolyData* data, const std::string& block)
  : Flags(FlagsIn(data->GetCellData(), data->GetNumberOfCells(), "cell", block))
{
}

bool GhostCells::IsGhost(vtkIdType cell) const
{
  constexpr int Ghost = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::HIDDENCELL;
  return this->Flags && (this->Flags->GetValue(cell) & Ghost) != 0;
}

bool GhostCells::IsCopy(vtkIdType cell) const
{
  constexpr int Gone = vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
  return this->Flags && (this->Flags->GetValue(cell) & Gone) == 0 &&
    (this->Flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

vtkUnsignedCharArray* GhostPointFlags(vtkPolyData* data, const std::string& block)
{
  return FlagsIn(data->GetPointData(), data->GetNumberOfPoints(), "point", block);
}

} // namespace Illumination
