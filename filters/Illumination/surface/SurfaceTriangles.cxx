// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/SurfaceTriangles.h"

#include "Illumination/surface/CellCopies.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/PolygonCutter.h"

#include "PhotonTransport/geometry/TriangleArea.h"
#include "PhotonTransport/scene/DataRounding.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace Illumination
{
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

vtkIdTypeArray* IdsIn(vtkDataSetAttributes* arrays, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(arrays->GetArray(name));
}

std::vector<vtkIdType> Values(vtkIdTypeArray* ids)
{
  return { ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues() };
}

glm::dvec3 PointOf(vtkPolyData* data, vtkIdType point)
{
  glm::dvec3 place;
  data->GetPoint(point, &place.x);
  return place;
}

bool IsSinglePrecision(vtkPolyData* data)
{
  return data->GetPoints() && data->GetPoints()->GetDataType() == VTK_FLOAT;
}

double RoundingOf(vtkPolyData* data)
{
  return IsSinglePrecision(data) ? PhotonTransport::SingleRounding
                                 : PhotonTransport::DoubleRounding;
}

/// Whether all corners lie on one line, the one from the first corner to the corner farthest from
/// it.
bool IsOnALine(vtkPolyData* data, const std::vector<vtkIdType>& corners, double rounding)
{
  const glm::dvec3 first = PointOf(data, corners.front());
  const auto distance = [&](vtkIdType p)
  {
    return glm::length(0.5 * PointOf(data, p) - 0.5 * first); // halves: no overflow
  };
  const glm::dvec3 farthest = PointOf(data,
    *std::max_element(corners.begin(), corners.end(),
      [&](vtkIdType a, vtkIdType b) { return distance(a) < distance(b); }));
  return std::none_of(corners.begin(), corners.end(),
    [&](vtkIdType p)
    { return PhotonTransport::HasArea(first, farthest, PointOf(data, p), rounding); });
}

/// Copies the cells that are part of the scene, each with the cell of the input that it comes from.
class SurfaceCells
{
public:
  SurfaceCells(vtkPolyData* data, const std::string& block)
    : Data(data)
    , Block(block)
    , Ghosts(data, block)
    , Rounding(RoundingOf(data))
  {
    this->Ids->SetName(CellIds);
  }

  /// The polygons that have three corners or more, and the triangles of strips.
  void Copy(SurfaceTriangles& result)
  {
    vtkIdType cell = this->Data->GetNumberOfVerts() + this->Data->GetNumberOfLines();
    for (vtkCellArray* cells : { this->Data->GetPolys(), this->Data->GetStrips() })
    {
      auto it = vtk::TakeSmartPointer(cells->NewIterator());
      for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        it->GetCurrentCell(size, ids);
        if (size < 3)
        {
          continue;
        }
        if (this->Ghosts.IsGhost(cell))
        {
          result.ghosts.Add(cell);
          continue;
        }
        RequireFiniteCorners(this->Data, size, ids, cell, this->Block);
        if (size == 3) // most cells; KeepThoseWithArea looks at them
        {
          this->Add(size, ids, cell);
        }
        else if (cells == this->Data->GetPolys())
        {
          this->AddPolygon(size, ids, cell, result.withoutArea);
        }
        else
        {
          this->AddStrip(size, ids, cell);
        }
      }
    }
  }

  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkIdTypeArray> Ids;

private:
  /// Adds a polygon without the corners that lie in the place of the corner before them: with these
  /// VTK would cut the wrong triangles.
  void AddPolygon(vtkIdType size, const vtkIdType* ids, vtkIdType cell, LeftOut& withoutArea)
  {
    this->Corners.assign(ids, ids + size);
    const auto samePlace = [&](vtkIdType a, vtkIdType b)
    { return a == b || PointOf(this->Data, a) == PointOf(this->Data, b); };
    this->Corners.erase(
      std::unique(this->Corners.begin(), this->Corners.end(), samePlace), this->Corners.end());
    while (this->Corners.size() > 1 && samePlace(this->Corners.front(), this->Corners.back()))
    {
      this->Corners.pop_back();
    }
    if (this->Corners.size() < 3 || IsOnALine(this->Data, this->Corners, this->Rounding))
    {
      withoutArea.Add(cell);
      return;
    }
    this->Add(static_cast<vtkIdType>(this->Corners.size()), this->Corners.data(), cell);
  }

  void AddStrip(vtkIdType size, const vtkIdType* ids, vtkIdType cell)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2; // every second triangle winds the other way
      const vtkIdType triangle[3] = { ids[i + odd], ids[i + 1 - odd], ids[i + 2] };
      this->Add(3, triangle, cell);
    }
  }

  void Add(vtkIdType size, const vtkIdType* corners, vtkIdType cell)
  {
    this->Cells->InsertNextCell(size, corners);
    this->Ids->InsertNextValue(cell);
  }

  vtkPolyData* Data;
  const std::string& Block;
  GhostCells Ghosts;
  double Rounding;
  std::vector<vtkIdType> Corners; ///< Of the polygon at hand.
};

/// A polygon of n corners gives n - 2 triangles unless it crosses or touches itself, which VTK does
/// not tell. @param cells What was cut, of a block with so many `blockCells`.
LeftOut FindUncut(
  const SurfaceCells& cells, const std::vector<vtkIdType>& cellOfTriangle, vtkIdType blockCells)
{
  std::vector<vtkIdType> missing(static_cast<std::size_t>(blockCells), 0);
  for (vtkIdType c = 0; c < cells.Cells->GetNumberOfCells(); ++c)
  {
    missing[static_cast<std::size_t>(cells.Ids->GetValue(c))] += cells.Cells->GetCellSize(c) - 2;
  }
  for (const vtkIdType cell : cellOfTriangle)
  {
    --missing[static_cast<std::size_t>(cell)];
  }
  LeftOut uncut;
  for (std::size_t cell = 0; cell < missing.size(); ++cell)
  {
    if (missing[cell] > 0)
    {
      uncut.Add(static_cast<vtkIdType>(cell));
    }
  }
  return uncut;
}

/// Removes the triangles without an area.
void KeepThoseWithArea(vtkPolyData* mesh, LeftOut& withoutArea)
{
  const double rounding = RoundingOf(mesh);
  const vtkIdType all = mesh->GetNumberOfPolys();
  vtkIdTypeArray* cells = IdsIn(mesh->GetCellData(), CellIds);
  vtkNew<vtkCellArray> kept;
  kept->AllocateExact(all, 3 * all);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(CellIds);
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* p = nullptr;
    it->GetCurrentCell(size, p);
    const vtkIdType cell = cells->GetValue(it->GetCurrentCellId());
    if (PhotonTransport::HasArea(
          PointOf(mesh, p[0]), PointOf(mesh, p[1]), PointOf(mesh, p[2]), rounding))
    {
      kept->InsertNextCell(size, p);
      ids->InsertNextValue(cell);
    }
    else
    {
      withoutArea.Add(cell);
    }
  }
  if (kept->GetNumberOfCells() < all)
  {
    mesh->SetPolys(kept);
    mesh->GetCellData()->Initialize();
    mesh->GetCellData()->AddArray(ids);
  }
}

} // namespace

SurfaceTriangles TrianglesOf(vtkPolyData* data, vtkDataArray* normals, const std::string& block)
{
  RequireValidCells(data, block);
  SurfaceTriangles result;
  SurfaceCells cells(data, block);
  cells.Copy(result);
  if (!normals)
  {
    StartCopiesAlike(cells.Cells); // WithNormals wants copies of triangles to be such
  }

  vtkNew<vtkPolyData> bare;
  bare->SetPoints(data->GetPoints());
  bare->SetPolys(cells.Cells);
  bare->GetCellData()->AddArray(cells.Ids);
  bare->GetPointData()->AddArray(Counting(PointIds, data->GetNumberOfPoints()));
  bare->GetPointData()->SetNormals(normals);

  result.mesh = CutPolygons(bare, CellIds);
  result.uncut = FindUncut(cells, CellsOfTriangles(result.mesh), data->GetNumberOfCells());
  KeepThoseWithArea(result.mesh, result.withoutArea);
  return result;
}

double RoundingOfPoints(vtkPolyData* data)
{
  return IsSinglePrecision(data) ? PhotonTransport::SingleHalfUnit : 0.0;
}

bool HasSurface(vtkPolyData* data)
{
  return data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0;
}

std::vector<vtkIdType> CellsOfTriangles(vtkPolyData* triangles)
{
  return Values(IdsIn(triangles->GetCellData(), CellIds));
}

std::vector<vtkIdType> PointsOfTriangles(vtkPolyData* triangles)
{
  return Values(IdsIn(triangles->GetPointData(), PointIds));
}

} // namespace Illumination
