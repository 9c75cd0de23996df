// SPDX-License-Identifier: BSD-3-Clause
#include "ComputedNormals.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

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

/// For each triangle the first one with the same corners in the same order but for their start.
std::vector<std::size_t> FirstOfCopies(std::vector<Corners> corners)
{
  for (Corners& c : corners)
  {
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  }
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return corners[a] != corners[b] ? corners[a] < corners[b] : a < b; });
  std::vector<std::size_t> first(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isCopy = i > 0 && corners[order[i]] == corners[order[i - 1]];
    first[order[i]] = isCopy ? first[order[i - 1]] : order[i];
  }
  return first;
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
  split->Update();
  return split->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* triangles, double featureAngle)
{
  const std::vector<Corners> corners = CornersOf(triangles);
  const std::vector<std::size_t> first = FirstOfCopies(corners);
  std::vector<Corners> kept;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("IlluminationTriangleIds");
  for (std::size_t t = 0; t < corners.size(); ++t)
  {
    if (first[t] == t)
    {
      kept.push_back(corners[t]);
      ids->InsertNextValue(static_cast<vtkIdType>(t));
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
    all[t] = all[first[t]]; // the first of copies comes before them
  }
  result->SetPolys(Cells(all));
  result->GetCellData()->ShallowCopy(triangles->GetCellData());
  return result;
}
