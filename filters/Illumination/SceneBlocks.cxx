// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBlocks.h"

#include "CellValues.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
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

/// The triangles of a block alone, with the ids of the cells and points they come from and with
/// normals.
vtkSmartPointer<vtkPolyData> Triangles(
  vtkPolyData* data, vtkDataArray* normals, double featureAngle)
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
  if (normals || triangles->GetOutput()->GetNumberOfPolys() == 0)
  {
    return triangles->GetOutput();
  }
  vtkNew<vtkPolyDataNormals> split;
  split->SetInputConnection(triangles->GetOutputPort());
  split->SetFeatureAngle(featureAngle);
  split->SplittingOn();
  split->ConsistencyOn();
  split->Update();
  return split->GetOutput();
}

std::string NameOf(const char* what, vtkIdType id, const SceneBlock& block)
{
  return what + (" " + std::to_string(id)) + block.name;
}

} // namespace

SceneBlocks::SceneBlocks(vtkDataObject* data, const SurfaceDescription& description)
{
  this->All.metresPerUnit = description.metresPerUnit;
  if (!(description.reflectance >= 0.0 && description.reflectance <= 1.0))
  {
    throw InputError(
      "Reflectance is " + std::to_string(description.reflectance) + "; it must be within [0, 1]");
  }
  if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    SceneBlock block;
    block.data = single;
    this->Append(std::move(block), description);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      SceneBlock block;
      block.data = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
      block.name = " of block " + std::to_string(it->GetCurrentFlatIndex());
      if (block.data)
      {
        this->Append(std::move(block), description);
      }
      else
      {
        ++this->OtherBlocks;
      }
    }
  }
  if (this->All.facets.empty())
  {
    throw InputError("the input has no polygons or triangle strips with an area to light");
  }
}

void SceneBlocks::Append(SceneBlock block, const SurfaceDescription& description)
{
  RequireValidCells(block.data, block.name);
  vtkDataArray* given = CheckedNormals(block.data, block.name);
  block.normalsWereComputed = !given;
  const auto mesh = Triangles(block.data, given, description.featureAngle);
  if (mesh->GetNumberOfPolys() == 0)
  {
    return;
  }
  block.firstVertex = this->All.points.size();
  block.firstFacet = this->All.facets.size();
  block.pointOfVertex = Values(mesh->GetPointData()->GetArray(PointIds));
  block.cellOfFacet = Values(mesh->GetCellData()->GetArray(CellIds));
  block.uncut = FindUncut(block.data, block.cellOfFacet);

  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 point, normal;
    mesh->GetPoint(p, &point.x);
    normals->GetTuple(p, &normal.x);
    this->All.points.push_back(point);
    this->All.normals.push_back(normal);
  }
  const auto offset = static_cast<unsigned>(block.firstVertex);
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    this->All.facets.emplace_back(offset + static_cast<unsigned>(ids[0]),
      offset + static_cast<unsigned>(ids[1]), offset + static_cast<unsigned>(ids[2]));
  }

  const CellValues reflectance = description.reflectanceArray.empty()
    ? CellValues(description.reflectance)
    : CellValues(block, description.reflectanceArray, { "reflectance", 1.0 });
  for (const vtkIdType cell : block.cellOfFacet)
  {
    this->All.reflectance.push_back(reflectance.Of(cell));
  }
  if (!description.exitanceArray.empty())
  {
    const CellValues exitance(block, description.exitanceArray, { "exitance", VTK_FLOAT_MAX });
    for (const vtkIdType cell : block.cellOfFacet)
    {
      this->All.exitance.push_back(exitance.Of(cell));
    }
  }
  this->Parts.push_back(std::move(block));
}

std::string SceneBlocks::NameOfFacet(std::size_t facet) const
{
  const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), facet,
    [](std::size_t f, const SceneBlock& block) { return f < block.firstFacet; });
  const SceneBlock& block = *(after - 1);
  return NameOf("cell", block.cellOfFacet[facet - block.firstFacet], block);
}

std::string SceneBlocks::NameOfVertex(std::size_t vertex) const
{
  const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), vertex,
    [](std::size_t v, const SceneBlock& block) { return v < block.firstVertex; });
  const SceneBlock& block = *(after - 1);
  return NameOf("point", block.pointOfVertex[vertex - block.firstVertex], block);
}
