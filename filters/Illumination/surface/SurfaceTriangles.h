// SPDX-License-Identifier: BSD-3-Clause
// The triangles that a surface's polygons and strips are made of.
#ifndef SurfaceTriangles_h
#define SurfaceTriangles_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace Illumination
{

/// Cells, or triangles of cells, that are not part of the scene.
struct LeftOut
{
  std::size_t number = 0;
  vtkIdType first = -1; ///< Cell id.
  void Add(vtkIdType cell, std::size_t count = 1)
  {
    this->first = this->number == 0 ? cell : std::min(this->first, cell);
    this->number += count;
  }
};

/// The triangles of a block, wound as their cells are, and what was left out.
struct SurfaceTriangles
{
  /// All points of the block, and the triangles that have an area; other filters never see the
  /// rest, whose edges and directions would spoil what they compute.
  vtkSmartPointer<vtkPolyData> mesh;
  LeftOut ghosts;      ///< Cells; see GhostCells.
  LeftOut withoutArea; ///< Triangles and polygons on a line; see PhotonTransport::HasArea.
  LeftOut uncut;       ///< Polygons that cross or touch themselves and so lack triangles.
};

/// Throws InputError for cells that are not valid (RequireValidCells) and for a corner that is not
/// finite. @param normals Point normals to keep, or null. @param block How messages name the data:
/// " of block 2", or "".
SurfaceTriangles TrianglesOf(vtkPolyData* data, vtkDataArray* normals, const std::string& block);

/// By how much the coordinates were rounded at most, relative to each (Surface::rounding).
double RoundingOfPoints(vtkPolyData* data);

/// Whether there is a polygon or a strip.
bool HasSurface(vtkPolyData* data);

/// For each triangle the cell, and for each point the point, of the input that it comes from. Both
/// still hold after filters that split points.
std::vector<vtkIdType> CellsOfTriangles(vtkPolyData* triangles);
std::vector<vtkIdType> PointsOfTriangles(vtkPolyData* triangles);

} // namespace Illumination

#endif
