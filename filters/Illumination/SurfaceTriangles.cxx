// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <numeric>

namespace
{

constexpr const char* CellIds = "IlluminationCellIds";
constexpr const char* PointIds = "IlluminationPointIds";

vtkSmartPointer<vtkIdTypeArray> Counting(const char* name, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfTuples(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType{ 0 });
  return ids;
}

std::vector<vtkIdType> Values(vtkDataArray* ids)
{
  auto* array = vtkIdTypeArray::SafeDownCast(ids);
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
}

/// Adds a cell and says which cell of the input it comes from.
struct CellsWithIds
{
  vtkCellArray* cells;
  vtkIdTypeArray* ids;
  void Add(vtkIdType size, const vtkIdType* points, vtkIdType cell) const
  {
    this->cells->InsertNextCell(size, points);
    this->ids->InsertNextValue(cell);
  }
};

/// The polygons that have three corners and the triangles of strips. VTK's triangle filter would
/// read beyond the end of a shorter strip.
void CopySurfaceCells(vtkPolyData* data, const CellsWithIds& copy)
{
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  auto it = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    it->GetCurrentCell(size, ids);
    if (size >= 3)
    {
      copy.Add(size, ids, cell);
    }
  }
  it = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2; // every second triangle winds the other way
      const vtkIdType triangle[3] = { ids[i + odd], ids[i + 1 - odd], ids[i + 2] };
      copy.Add(3, triangle, cell);
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> Triangles(vtkPolyData* data, vtkDataArray* normals)
{
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName(CellIds);
  CopySurfaceCells(data, { cells, cellIds });

  vtkNew<vtkPolyData> bare;
  bare->SetPoints(data->GetPoints());
  bare->SetPolys(cells);
  bare->GetCellData()->AddArray(cellIds);
  bare->GetPointData()->AddArray(Counting(PointIds, data->GetNumberOfPoints()));
  bare->GetPointData()->SetNormals(normals);

  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(bare);
  triangles->Update();
  return triangles->GetOutput();
}

std::vector<vtkIdType> CellsOfTriangles(vtkPolyData* triangles)
{
  return Values(triangles->GetCellData()->GetArray(CellIds));
}

std::vector<vtkIdType> PointsOfTriangles(vtkPolyData* triangles)
{
  return Values(triangles->GetPointData()->GetArray(PointIds));
}
