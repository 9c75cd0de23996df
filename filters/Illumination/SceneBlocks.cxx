// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBlocks.h"

#include "CellValues.h"
#include "ComputedNormals.h"
#include "FacetMaterials.h"
#include "GhostPoints.h"
#include "InputChecks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{

std::string NameOf(const char* what, vtkIdType id, const SceneBlock& block)
{
  return what + (" " + std::to_string(id)) + block.name;
}

/// How many cells were none for being ghosts, as the end of a message.
std::string GhostsOf(const std::vector<SceneBlock>& blocks)
{
  std::size_t ghosts = 0;
  for (const SceneBlock& block : blocks)
  {
    ghosts += block.ghosts.number;
  }
  return ghosts == 0 ? ""
                     : "; the array vtkGhostType marks " + std::to_string(ghosts) +
      " cells as duplicate, refined or hidden, which are not part of the scene";
}

/// The vertices of a block's points, in the order of the points.
std::vector<BorrowedVertex> VerticesByPoint(const SceneBlock& block)
{
  std::vector<BorrowedVertex> vertices;
  for (std::size_t v = 0; v < block.pointOfVertex.size(); ++v)
  {
    vertices.push_back({ block.firstVertex + v, static_cast<std::size_t>(block.pointOfVertex[v]) });
  }
  std::stable_sort(vertices.begin(), vertices.end(),
    [](const BorrowedVertex& a, const BorrowedVertex& b) { return a.point < b.point; });
  return vertices;
}

/// Those of one point.
std::vector<BorrowedVertex> VerticesOf(const std::vector<BorrowedVertex>& byPoint, vtkIdType point)
{
  const auto before = [](const BorrowedVertex& a, const BorrowedVertex& b)
  { return a.point < b.point; };
  const auto [first, last] = std::equal_range(
    byPoint.begin(), byPoint.end(), BorrowedVertex{ 0, static_cast<std::size_t>(point) }, before);
  return { first, last };
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
    throw InputError(
      "the input has no polygons or triangle strips with an area to light" + GhostsOf(this->Unlit));
  }
  DescribeMaterials(this->Parts, description, this->All);
  this->AppendUnlit();
  this->LendVertices();
}

void SceneBlocks::Append(SceneBlock block, const SurfaceDescription& description)
{
  vtkDataArray* given = CheckedNormals(block.data, block.name);
  const SurfaceTriangles triangles = TrianglesOf(block.data, given, block.name);
  block.ghosts = triangles.ghosts;
  block.withoutArea = triangles.withoutArea;
  block.uncut = triangles.uncut;
  if (triangles.mesh->GetNumberOfPolys() == 0)
  {
    if (HasSurface(block.data))
    {
      this->Unlit.push_back(std::move(block));
    }
    return;
  }
  block.normalsWereComputed = !given;
  const vtkSmartPointer<vtkPolyData> mesh =
    given ? triangles.mesh : WithNormals(triangles.mesh, description.featureAngle);
  block.firstVertex = this->All.points.size();
  block.firstFacet = this->All.facets.size();
  block.pointOfVertex = PointsOfTriangles(mesh);
  block.cellOfFacet = CellsOfTriangles(mesh);
  this->AddVertices(mesh);
  this->AddFacets(mesh, block.firstVertex);
  if (!description.exitanceArray.empty())
  {
    this->AddExitance(block, description.exitanceArray);
  }
  this->Parts.push_back(std::move(block));
}

void SceneBlocks::AddVertices(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 point, normal;
    mesh->GetPoint(p, &point.x);
    normals->GetTuple(p, &normal.x);
    this->All.points.push_back(point);
    this->All.normals.push_back(normal);
  }
}

void SceneBlocks::AddFacets(vtkPolyData* mesh, std::size_t firstVertex)
{
  const auto offset = static_cast<unsigned>(firstVertex);
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    this->All.facets.emplace_back(offset + static_cast<unsigned>(ids[0]),
      offset + static_cast<unsigned>(ids[1]), offset + static_cast<unsigned>(ids[2]));
  }
}

void SceneBlocks::AddExitance(const SceneBlock& block, const std::string& array)
{
  const CellValues exitance(block, array, { "exitance", VTK_FLOAT_MAX });
  for (const vtkIdType cell : block.cellOfFacet)
  {
    this->All.exitance.push_back(PhotonTransport::Luminous(exitance.Of(cell)));
    this->All.exitanceColour.push_back(exitance.Of(cell));
  }
}

/// Blocks without a triangle get arrays as the others do, or the output would have them in part.
void SceneBlocks::AppendUnlit()
{
  for (SceneBlock& block : this->Unlit)
  {
    block.firstVertex = this->All.points.size();
    block.firstFacet = this->All.facets.size();
    this->Parts.push_back(std::move(block));
  }
  this->Unlit.clear();
}

void SceneBlocks::LendVertices()
{
  std::vector<std::pair<vtkPolyData*, std::string>> blocks;
  for (const SceneBlock& block : this->Parts)
  {
    blocks.emplace_back(block.data, block.name);
  }
  const std::vector<GhostPoints> ghosts = FindGhostPoints(blocks);
  std::vector<std::vector<BorrowedVertex>> byPoint; // of each block
  for (std::size_t b = 0; b < this->Parts.size() && !ghosts.empty(); ++b)
  {
    byPoint.push_back(VerticesByPoint(this->Parts[b]));
  }
  for (std::size_t b = 0; b < ghosts.size(); ++b)
  {
    SceneBlock& block = this->Parts[b];
    block.ownerlessGhosts = ghosts[b].ownerless;
    block.firstOwnerlessGhost = ghosts[b].firstOwnerless;
    block.borrows.assign(static_cast<std::size_t>(block.data->GetNumberOfPoints()), false);
    for (const GhostPoint& ghost : ghosts[b].owned)
    {
      const auto point = static_cast<std::size_t>(ghost.point);
      block.borrows[point] = true;
      for (const BorrowedVertex& v : VerticesOf(byPoint[ghost.ownerBlock], ghost.owner))
      {
        block.borrowed.push_back({ v.vertex, point });
      }
    }
  }
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
