// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputChecks_h
#define InputChecks_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

/// Throws InputError unless every cell array is what VTK takes it for and every index of a polygon
/// or strip is one of a point: VTK's filters follow offsets and indices without a look.
/// @param block How messages name the data: " of block 2", or "".
void RequireValidCells(vtkPolyData* data, const std::string& block);

/// Point normals as the pipeline marks them, or else the point array of that name; null if there is
/// neither. Throws InputError if it does not hold three numbers a point.
vtkDataArray* CheckedNormals(vtkPolyData* data, const std::string& block);

/// The cell array of that name. Throws InputError unless it holds numbers, one tuple a cell of one
/// component or, where allowed, three.
vtkDataArray* CheckedCellArray(
  vtkPolyData* data, const std::string& name, const std::string& block, bool threeAllowed = true);

/// Polygons that were not cut into all the triangles they should give.
struct UncutPolygons
{
  std::size_t number = 0;
  vtkIdType first = -1; ///< Cell id.
};

/// A polygon of n corners gives n - 2 triangles unless it crosses or touches itself or has no area,
/// which VTK does not tell. @param cellOfTriangle For each triangle the cell it was cut from.
UncutPolygons FindUncut(vtkPolyData* data, const std::vector<vtkIdType>& cellOfTriangle);

#endif
