// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputChecks_h
#define InputChecks_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkPolyData;

/// Throws InputError unless every cell array is what VTK takes it for and every index of a polygon
/// or strip is one of a point: VTK's filters follow offsets and indices without a look.
/// @param block How messages name the data: " of block 2", or "".
void RequireValidCells(vtkPolyData* data, const std::string& block);

/// Throws InputError, which names the point and the cell, for a corner whose coordinates are not
/// all finite: VTK's filters would cut a hole or compute no number.
void RequireFiniteCorners(vtkPolyData* data, vtkIdType size, const vtkIdType* corners,
  vtkIdType cell, const std::string& block);

/// Throws InputError, which begins with `where`, unless the array holds numbers, `count` tuples of
/// one of the numbers of components. @param owners What has a tuple each: "points" or "cells".
vtkDataArray* CheckedNumbers(vtkAbstractArray* found, const std::string& where,
  const std::vector<int>& components, vtkIdType count, const char* owners);

/// Point normals as the pipeline marks them, or else the point array of that name; null if there is
/// neither. Throws InputError if it does not hold three numbers a point.
vtkDataArray* CheckedNormals(vtkPolyData* data, const std::string& block);

/// The cell array of that name. Throws InputError unless it holds numbers, one tuple a cell of one
/// component or, where allowed, three.
vtkDataArray* CheckedCellArray(
  vtkPolyData* data, const std::string& name, const std::string& block, bool threeAllowed = true);

#endif
