// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/SceneBlocks.h"

#include "Illumination/materials/FacetMaterials.h"
#include "Illumination/materials/OpeningCells.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/CellExitance.h"
#include "Illumination/surface/ComputedNormals.h"
#include "Illumination/surface/GhostPoints.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/TriangleOrder.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <stdexcept>

namespace Illumination
{
namespace
{

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
  const SurfaceParts parts = PartsOf(data);
  this->OtherBlocks = parts.others;
  for (const NamedSurface& part : parts.surfaces)
  {
    this->Append(SceneBlock(part), description);
  }
  if (this->All.facets.empty())
  {
    throw InputError(
      "the input has no polygons or triangle strips with an area to light" + GhostsOf(this->Unlit));
  }
  DescribeMaterials(this->Parts, description, this->All);
  DescribeOpenings(this->Parts, description, this->All);
  this->AppendUnlit();
  this->LendVertices();
}

void SceneBlocks::LieIn(vtkDataObject* data)
{
  const SurfaceParts parts = PartsOf(data);
  for (SceneBlock& block : this->Parts)
  {
    const auto same = std::find_if(parts.surfaces.begin(), parts.surfaces.end(),
      [&](const NamedSurface& part) { return part.number == block.number; });
    if (same == parts.surfaces.end())
    {
      throw std::logic_error("blocks are not those of the same data");
    }
    block.data = same->data;
  }
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
  const vtkSmartPointer<vtkPolyData> ordered = OrderedByPlace(triangles.mesh, block.data);
  const vtkSmartPointer<vtkPolyData> mesh =
    given ? ordered : WithNormals(ordered, description.featureAngle);
  block.firstVertex = this->All.points.size();
  block.firstFacet = this->All.facets.size();
  block.pointOfVertex = PointsOfTriangles(mesh);
  block.cellOfFacet = CellsOfTriangles(mesh);
  AppendPoints(mesh, this->All.points);
  this->All.rounding = std::max(this->All.rounding, RoundingOfPoints(block.data));
  AppendNormals(mesh, this->All.normals);
  AppendFacets(mesh, block.firstVertex, this->All.facets);
  if (!description.exitanceArray.empty())
  {
    const std::vector<PhotonTransport::Colour> exitance =
      ExitanceOf(block, description.exitanceArray, block.cellOfFacet);
    this->All.exitance.insert(this->All.exitance.end(), exitance.begin(), exitance.end());
  }
  this->Parts.push_back(std::move(block));
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
  const std::vector<GhostPoints> ghosts =
    FindGhostPoints({ this->Parts.begin(), this->Parts.end() });
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
  return NameOfCell(block.data, block.cellOfFacet[facet - block.firstFacet], block.name);
}

std::string SceneBlocks::NameOfVertex(std::size_t vertex) const
{
  const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), vertex,
    [](std::size_t v, const SceneBlock& block) { return v < block.firstVertex; });
  const SceneBlock& block = *(after - 1);
  return NameOfPoint(block.data, block.pointOfVertex[vertex - block.firstVertex], block.name);
}

std::string SceneBlocks::WordsFor(const PhotonTransport::InvalidInput& error) const
{
  using Where = PhotonTransport::InvalidInput::Where;
  switch (error.Kind)
  {
    case Where::Facet:
      return this->NameOfFacet(error.Index) + ": " + error.what();
    case Where::Point:
      return this->NameOfVertex(error.Index) + ": " + error.what();
    default:
      return error.what();
  }
}

} // namespace Illumination
