// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputChecks_h
#define InputChecks_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkPolyData;

namespace Illumination
{

/// Throws InputError unless the offsets of all cells are consistent and all indices of polygons and
/// strips are those of points. VTK's filters use both without checking them.
/// @param block How messages name the data: " of block 2", or "".
void RequireValidCells(vtkPolyData* data, const std::string& block);

/// Throws InputError unless all point and cell arrays have a tuple for each point and cell.
void RequireArraySizes(vtkPolyData* data, const std::string& block);

/// Throws InputError, which names the point and the cell, for a corner whose coordinates are not
/// all finite. VTK's filters would leave a hole or compute NaN.
void RequireFiniteCorners(vtkPolyData* data, vtkIdType size, const vtkIdType* corners,
  vtkIdType cell, const std::string& block);

/// Throws InputError, which begins with `where`, unless the array holds numbers, `count` tuples of
/// one of the numbers of components. @param owners What has a tuple each: "points" or "cells".
vtkDataArray* CheckedNumbers(vtkAbstractArray* found, const std::string& where,
  const std::vector<int>& components, vtkIdType count, const char* owners);

/// The array that the point data name as their normals, or else the point array "Normals"; null if
/// there is neither. Throws InputError if it does not hold three numbers a point.
vtkDataArray* CheckedNormals(vtkPolyData* data, const std::string& block);

/// The cell array of that name. Throws InputError unless there is one that holds numbers, with one
/// tuple a cell and one component or, where allowed, three.
vtkDataArray* CheckedCellArray(
  vtkPolyData* data, const std::string& name, const std::string& block, bool threeAllowed = true);

} // namespace Illumination

#endif
