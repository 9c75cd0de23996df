// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBlocks.h"

#include "CellValues.h"
#include "FacetMaterials.h"
#include "SurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>

namespace
{

/// The triangles of a block with normals, which split points at edges where they are computed.
vtkSmartPointer<vtkPolyData> TrianglesWithNormals(
  vtkPolyData* data, vtkDataArray* normals, double featureAngle)
{
  const auto triangles = Triangles(data, normals);
  if (normals || triangles->GetNumberOfPolys() == 0)
  {
    return triangles;
  }
  vtkNew<vtkPolyDataNormals> split;
  split->SetInputData(triangles);
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
  DescribeMaterials(this->Parts, description, this->All);
}

void SceneBlocks::Append(SceneBlock block, const SurfaceDescription& description)
{
  RequireValidCells(block.data, block.name);
  vtkDataArray* given = CheckedNormals(block.data, block.name);
  block.normalsWereComputed = !given;
  const auto mesh = TrianglesWithNormals(block.data, given, description.featureAngle);
  if (mesh->GetNumberOfPolys() == 0)
  {
    return;
  }
  block.firstVertex = this->All.points.size();
  block.firstFacet = this->All.facets.size();
  block.pointOfVertex = PointsOfTriangles(mesh);
  block.cellOfFacet = CellsOfTriangles(mesh);
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

  if (!description.exitanceArray.empty())
  {
    const CellValues exitance(block, description.exitanceArray, { "exitance", VTK_FLOAT_MAX });
    for (const vtkIdType cell : block.cellOfFacet)
    {
      this->All.exitance.push_back(PhotonTransport::Luminous(exitance.Of(cell)));
      this->All.exitanceColour.push_back(exitance.Of(cell));
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
