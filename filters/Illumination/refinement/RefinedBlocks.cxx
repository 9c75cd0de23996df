// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/refinement/RefinedBlocks.h"

#include "Illumination/refinement/RefinedArrays.h"
#include "Illumination/surface/GhostCells.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace Illumination
{
namespace
{

vtkIdType CellOf(std::size_t fine, const RefinementBlock& block, const FinePart& part)
{
  return block.cellOfFacet[part.fine.origins[fine].facet - block.firstFacet];
}

/// The facets of a part in the order of the block's cells, which may not be that of the mesh.
std::vector<std::size_t> ByCell(const RefinementBlock& block, const FinePart& part)
{
  std::vector<std::size_t> facets(part.end - part.first);
  std::iota(facets.begin(), facets.end(), part.first);
  std::stable_sort(facets.begin(), facets.end(),
    [&](std::size_t a, std::size_t b) { return CellOf(a, block, part) < CellOf(b, block, part); });
  return facets;
}

/// The cells of a refined block, and the cells that they come from.
struct RefinedCells
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  vtkNew<vtkIdList> origins;

  RefinedCells(
    const RefinementBlock& block, const FinePart& part, const std::vector<vtkIdType>& idOfFinePoint)
  {
    const vtkIdType first = block.data->GetNumberOfVerts() + block.data->GetNumberOfLines();
    for (vtkIdType cell = 0; cell < first; ++cell)
    {
      this->origins->InsertNextId(cell);
    }
    for (const std::size_t f : ByCell(block, part))
    {
      const glm::uvec3& corners = part.fine.facets[f];
      const vtkIdType ids[3] = { idOfFinePoint[corners.x], idOfFinePoint[corners.y],
        idOfFinePoint[corners.z] };
      this->polygons->InsertNextCell(3, ids);
      this->origins->InsertNextId(CellOf(f, block, part));
    }
    this->AddWhole(block, first);
  }

  vtkIdType Number() const { return this->origins->GetNumberOfIds(); }

private:
  /// Adds polygons and strips without a part in the mesh.
  void AddWhole(const RefinementBlock& block, vtkIdType cell)
  {
    std::vector<bool> divided(static_cast<std::size_t>(block.data->GetNumberOfCells()), false);
    for (const vtkIdType c : block.cellOfFacet)
    {
      divided[static_cast<std::size_t>(c)] = true;
    }
    for (vtkCellArray* cells : { block.data->GetPolys(), block.data->GetStrips() })
    {
      vtkCellArray* whole = cells == block.data->GetPolys() ? this->polygons : this->strips;
      auto it = vtk::TakeSmartPointer(cells->NewIterator());
      for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
      {
        if (!divided[static_cast<std::size_t>(cell)])
        {
          vtkIdType size = 0;
          const vtkIdType* ids = nullptr;
          it->GetCurrentCell(size, ids);
          whole->InsertNextCell(size, ids);
          this->origins->InsertNextId(cell);
        }
      }
    }
  }
};

vtkSmartPointer<vtkPoints> PointsOf(
  const RefinementBlock& block, const RefinedPoints& points, int precision)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataType(precision);
  result->SetNumberOfPoints(points.Number());
  if (points.NumberGiven() > 0)
  {
    result->InsertPoints(0, points.NumberGiven(), 0, block.data->GetPoints());
  }
  vtkIdType id = points.NumberGiven();
  for (const AddedPoint& point : points.Added())
  {
    result->SetPoint(id++, &point.place.x);
  }
  return result;
}

void AddCellArrays(const RefinementBlock& block, const RefinedCells& cells, vtkCellData* result)
{
  vtkNew<vtkIdList> all;
  all->SetNumberOfIds(cells.Number());
  std::iota(all->begin(), all->end(), vtkIdType{ 0 });
  result->CopyAllocate(block.data->GetCellData(), cells.Number());
  result->CopyData(block.data->GetCellData(), cells.origins, all);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalCellIds");
  ids->SetNumberOfTuples(cells.Number());
  std::copy(cells.origins->begin(), cells.origins->end(), ids->GetPointer(0));
  result->AddArray(ids);
}

void AddOriginalPointIds(
  const RefinementBlock& block, const RefinedPoints& points, vtkPointData* result)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalPointIds");
  ids->SetNumberOfTuples(points.Number());
  vtkIdType* next = ids->GetPointer(0);
  std::iota(next, next + points.NumberGiven(), vtkIdType{ 0 });
  next += points.NumberGiven();
  for (const AddedPoint& point : points.Added())
  {
    *next++ = point.isCopy ? block.pointOfVertex[point.Nearest() - block.firstVertex] : -1;
  }
  result->AddArray(ids);
}

/// Marks new points as copies of another block's if only copies of its cells have them, where the
/// block marks points at all.
void MarkCopiedPoints(const RefinementBlock& block, vtkIdType firstAdded, vtkPolyData* result)
{
  vtkUnsignedCharArray* flags = result->GetPointGhostArray();
  const GhostCells ghosts(result, block.name);
  if (!flags || !ghosts.Any())
  {
    return;
  }
  std::vector<bool> owned(static_cast<std::size_t>(result->GetNumberOfPoints()), false);
  vtkIdType cell = result->GetNumberOfVerts() + result->GetNumberOfLines();
  auto it = vtk::TakeSmartPointer(result->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size && !ghosts.IsGhost(cell); ++i)
    {
      owned[static_cast<std::size_t>(ids[i])] = true;
    }
  }
  for (vtkIdType p = firstAdded; p < result->GetNumberOfPoints(); ++p)
  {
    if (!owned[static_cast<std::size_t>(p)])
    {
      flags->SetValue(p, flags->GetValue(p) | vtkDataSetAttributes::DUPLICATEPOINT);
    }
  }
}

vtkSmartPointer<vtkPolyData> RefinedBlock(const RefinementBlock& block, const FinePart& part,
  int precision, std::vector<vtkIdType>& idOfFinePoint)
{
  const RefinedPoints points(block, part, idOfFinePoint);
  const RefinedCells cells(block, part, idOfFinePoint);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(PointsOf(block, points, precision));
  result->SetVerts(block.data->GetVerts());
  result->SetLines(block.data->GetLines());
  result->SetPolys(cells.polygons);
  result->SetStrips(cells.strips);
  AddPointArrays(block, points, part.mesh.normals, result->GetPointData());
  AddOriginalPointIds(block, points, result->GetPointData());
  AddCellArrays(block, cells, result->GetCellData());
  MarkCopiedPoints(block, points.NumberGiven(), result);
  result->GetFieldData()->PassData(block.data->GetFieldData());
  return result;
}

} // namespace

std::vector<vtkSmartPointer<vtkPolyData>> RefinedBlocks(const RefinementBlocks& blocks,
  const PhotonTransport::RefinedMesh& fine, std::vector<vtkIdType>* pointOfFine)
{
  const PhotonTransport::TriangleMesh mesh = blocks.Mesh();
  // One precision for all, since a point on an edge between two blocks is one place.
  int precision = VTK_FLOAT;
  for (const RefinementBlock& block : blocks.Blocks())
  {
    vtkPoints* points = block.data->GetPoints();
    precision = points && points->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : precision;
  }
  std::vector<vtkIdType> idOfFinePoint(fine.points.size(), -1);
  std::vector<vtkSmartPointer<vtkPolyData>> result;
  std::size_t first = 0;
  for (const RefinementBlock& block : blocks.Blocks())
  {
    std::size_t end = first;
    while (end < fine.facets.size() &&
      fine.origins[end].facet < block.firstFacet + block.cellOfFacet.size())
    {
      ++end;
    }
    result.push_back(RefinedBlock(block, { mesh, fine, first, end }, precision, idOfFinePoint));
    first = end;
  }
  if (pointOfFine)
  {
    *pointOfFine = std::move(idOfFinePoint);
  }
  return result;
}

} // namespace Illumination
