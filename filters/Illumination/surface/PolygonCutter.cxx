// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/PolygonCutter.h"

#include "PhotonTransport/threads/Threads.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Illumination
{
namespace
{

/// Triangles of some polygons.
struct Triangles
{
  std::vector<vtkIdType> corners; ///< Three of each triangle.
  std::vector<vtkIdType> polygons;
};

/// Reads only what threads may read at the same time.
class Cutter
{
public:
  explicit Cutter(vtkPolyData* mesh)
    : Mesh(mesh)
  {
  }

  Triangles Cut(vtkIdType first, vtkIdType last)
  {
    Triangles triangles;
    for (vtkIdType polygon = first; polygon < last; ++polygon)
    {
      this->Mesh->GetPolys()->GetCellAtId(polygon, this->Corners);
      if (this->Corners->GetNumberOfIds() == 3)
      {
        this->OfTriangles->DeepCopy(this->Corners);
      }
      else
      {
        this->CutPolygon();
      }
      this->AddTo(triangles, polygon);
    }
    return triangles;
  }

private:
  void CutPolygon()
  {
    const vtkIdType size = this->Corners->GetNumberOfIds();
    this->Polygon->PointIds->DeepCopy(this->Corners);
    this->Polygon->Points->SetNumberOfPoints(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double place[3];
      this->Mesh->GetPoint(this->Corners->GetId(i), place);
      this->Polygon->Points->SetPoint(i, place);
    }
    // No more than it could cut where it fails. All versions of VTK have this overload.
    this->Polygon->Triangulate(0, this->OfTriangles, this->PlacesOfTriangles);
  }

  void AddTo(Triangles& triangles, vtkIdType polygon) const
  {
    const vtkIdType number = this->OfTriangles->GetNumberOfIds() / 3;
    for (vtkIdType i = 0; i < 3 * number; ++i)
    {
      triangles.corners.push_back(this->OfTriangles->GetId(i));
    }
    triangles.polygons.insert(triangles.polygons.end(), static_cast<std::size_t>(number), polygon);
  }

  vtkPolyData* Mesh;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;     ///< Of the polygon at hand.
  vtkNew<vtkIdList> OfTriangles; ///< Three of each of its triangles.
  vtkNew<vtkPoints> PlacesOfTriangles;
};

/// [chunk of polygons]
std::vector<Triangles> CutInChunks(vtkPolyData* mesh)
{
  constexpr vtkIdType Chunk = 4096;
  const vtkIdType polygons = mesh->GetNumberOfPolys();
  std::vector<Triangles> chunks(static_cast<std::size_t>((polygons + Chunk - 1) / Chunk));
  PhotonTransport::ForEach(
    chunks.size(),
    [&](std::size_t c)
    {
      const vtkIdType first = static_cast<vtkIdType>(c) * Chunk;
      chunks[c] = Cutter(mesh).Cut(first, std::min(first + Chunk, polygons));
    },
    1);
  return chunks;
}

} // namespace

vtkSmartPointer<vtkPolyData> CutPolygons(vtkPolyData* mesh, const char* cellArray)
{
  if (mesh->GetPolys()->GetMaxCellSize() <= 3)
  {
    return mesh;
  }
  auto* values = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(cellArray));
  vtkNew<vtkIdTypeArray> corners, ofTriangles;
  ofTriangles->SetName(cellArray);
  vtkIdType triangles = 0;
  const std::vector<Triangles> chunks = CutInChunks(mesh);
  for (const Triangles& chunk : chunks)
  {
    triangles += static_cast<vtkIdType>(chunk.polygons.size());
  }
  corners->SetNumberOfValues(3 * triangles);
  ofTriangles->SetNumberOfValues(triangles);
  vtkIdType* corner = corners->GetPointer(0);
  vtkIdType* value = ofTriangles->GetPointer(0);
  for (const Triangles& chunk : chunks)
  {
    corner = std::copy(chunk.corners.begin(), chunk.corners.end(), corner);
    value = std::transform(chunk.polygons.begin(), chunk.polygons.end(), value,
      [&](vtkIdType polygon) { return values->GetValue(polygon); });
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, corners);
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  cut->SetPoints(mesh->GetPoints());
  cut->SetPolys(cells);
  cut->GetPointData()->PassData(mesh->GetPointData());
  cut->GetCellData()->AddArray(ofTriangles);
  return cut;
}

} // namespace Illumination
