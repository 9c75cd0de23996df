// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/InputChecks.h"

#include "Illumination/pipeline/InputError.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace Illumination
{
namespace
{

void RequireConsistency(vtkCellArray* cells, const std::string& what)
{
  // No offset at all would mean -1 cells.
  if (cells->GetNumberOfOffsets() < 1 || !cells->IsValid())
  {
    throw InputError("the " + what +
      " contradict themselves: their offsets do not rise from 0 to " +
      std::to_string(cells->GetNumberOfConnectivityIds()) + ", the number of their point ids");
  }
}

void RequireSizes(
  vtkDataSetAttributes* arrays, vtkIdType wanted, const char* kind, const std::string& block)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != wanted)
    {
      const std::string name = array->GetName() ? array->GetName() : "";
      throw InputError(std::string(kind) + " array '" + name + "'" + block + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(wanted) + " " +
        kind + "s");
    }
  }
}

} // namespace

void RequireArraySizes(vtkPolyData* data, const std::string& block)
{
  RequireSizes(data->GetPointData(), data->GetNumberOfPoints(), "point", block);
  RequireSizes(data->GetCellData(), data->GetNumberOfCells(), "cell", block);
}

void RequireValidCells(vtkPolyData* data, const std::string& block)
{
  const std::pair<vtkCellArray*, const char*> kinds[] = { { data->GetVerts(), "vertices" },
    { data->GetLines(), "lines" }, { data->GetPolys(), "polygons" },
    { data->GetStrips(), "triangle strips" } };
  for (const auto& [cells, what] : kinds)
  {
    RequireConsistency(cells, what + block);
  }

  const vtkIdType points = data->GetNumberOfPoints();
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] < 0 || ids[i] >= points)
        {
          throw InputError("cell " + std::to_string(cell) + block + " uses point " +
            std::to_string(ids[i]) + " of " + std::to_string(points));
        }
      }
    }
  }
}

void RequireFiniteCorners(vtkPolyData* data, vtkIdType size, const vtkIdType* corners,
  vtkIdType cell, const std::string& block)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::array<double, 3> x{};
    data->GetPoint(corners[i], x.data());
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      std::ostringstream message;
      message << "point " << corners[i] << block << ": its coordinates (" << x[0] << ", " << x[1]
              << ", " << x[2] << "), which cell " << cell << " uses, are not finite";
      throw InputError(message.str());
    }
  }
}

vtkDataArray* CheckedNumbers(vtkAbstractArray* found, const std::string& where,
  const std::vector<int>& components, vtkIdType count, const char* owners)
{
  auto* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    throw InputError(where + " is a " + found->GetClassName() + ", not numbers");
  }
  if (std::find(components.begin(), components.end(), array->GetNumberOfComponents()) ==
    components.end())
  {
    std::string wanted = std::to_string(components.front());
    wanted += components.size() > 1 ? " or " + std::to_string(components.back()) : "";
    throw InputError(where + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components; " + wanted + (wanted == "1" ? " is wanted" : " are wanted"));
  }
  if (array->GetNumberOfTuples() != count)
  {
    throw InputError(where + " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(count) + " " + owners);
  }
  return array;
}

vtkDataArray* CheckedNormals(vtkPolyData* data, const std::string& block)
{
  vtkAbstractArray* found = data->GetPointData()->GetNormals();
  found = found ? found : data->GetPointData()->GetAbstractArray("Normals");
  if (!found)
  {
    return nullptr;
  }
  const std::string where =
    "point array '" + std::string(found->GetName() ? found->GetName() : "") + "'" + block;
  return CheckedNumbers(found, where, { 3 }, data->GetNumberOfPoints(), "points");
}

vtkDataArray* CheckedCellArray(
  vtkPolyData* data, const std::string& name, const std::string& block, bool threeAllowed)
{
  vtkAbstractArray* found = data->GetCellData()->GetAbstractArray(name.c_str());
  const std::string where = "cell array '" + name + "'" + block;
  if (!found)
  {
    const bool onPoints = data->GetPointData()->HasArray(name.c_str()) != 0;
    throw InputError("there is no " + where +
      (onPoints ? "; there is a point array of that name, but values must be per cell" : ""));
  }
  const std::vector<int> components =
    threeAllowed ? std::vector<int>{ 1, 3 } : std::vector<int>{ 1 };
  return CheckedNumbers(found, where, components, data->GetNumberOfCells(), "cells");
}

} // namespace Illumination
