// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/ComputedNormals.h"

#include "Illumination/surface/CellCopies.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Illumination
{
namespace
{

using Corners = std::array<vtkIdType, 3>;

std::vector<Corners> CornersOf(vtkPolyData* triangles)
{
  std::vector<Corners> corners;
  corners.reserve(static_cast<std::size_t>(triangles->GetNumberOfPolys()));
  auto it = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    corners.push_back({ ids[0], ids[1], ids[2] });
  }
  return corners;
}

vtkSmartPointer<vtkCellArray> Cells(const std::vector<Corners>& triangles)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto number = static_cast<vtkIdType>(triangles.size());
  cells->AllocateExact(number, 3 * number);
  for (const Corners& corners : triangles)
  {
    cells->InsertNextCell(3, corners.data());
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> SplitByVtk(vtkPolyData* triangles, double featureAngle)
{
  vtkNew<vtkPolyDataNormals> split;
  split->SetInputData(triangles);
  split->SetFeatureAngle(featureAngle);
  split->SplittingOn();
  split->ConsistencyOn();
  // Otherwise VTK passes the side of a triangle on across edges of three triangles and more: one
  // sliver along an edge, or a shelf on a wall, could turn all that it touches.
  split->NonManifoldTraversalOff();
  split->Update();
  return split->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* triangles, double featureAngle)
{
  const std::vector<Corners> corners = CornersOf(triangles);
  const std::vector<vtkIdType> first = FirstOfCopies(triangles->GetPolys());
  std::vector<Corners> kept;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("IlluminationTriangleIds");
  for (std::size_t t = 0; t < corners.size(); ++t)
  {
    const auto id = static_cast<vtkIdType>(t);
    if (first[t] == id)
    {
      kept.push_back(corners[t]);
      ids->InsertNextValue(id);
    }
  }
  if (kept.size() == corners.size())
  {
    return SplitByVtk(triangles, featureAngle);
  }
  vtkNew<vtkPolyData> originals;
  originals->SetPoints(triangles->GetPoints());
  originals->GetPointData()->ShallowCopy(triangles->GetPointData());
  originals->SetPolys(Cells(kept));
  originals->GetCellData()->AddArray(ids);
  vtkSmartPointer<vtkPolyData> result = SplitByVtk(originals, featureAngle);

  const std::vector<Corners> split = CornersOf(result);
  auto* from = vtkIdTypeArray::SafeDownCast(result->GetCellData()->GetArray(ids->GetName()));
  std::vector<Corners> all(corners.size());
  for (std::size_t i = 0; i < split.size(); ++i)
  {
    all[static_cast<std::size_t>(from->GetValue(static_cast<vtkIdType>(i)))] = split[i];
  }
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    all[t] = all[static_cast<std::size_t>(first[t])]; // the first of copies comes before them
  }
  result->SetPolys(Cells(all));
  result->GetCellData()->ShallowCopy(triangles->GetCellData());
  return result;
}

} // namespace Illumination
