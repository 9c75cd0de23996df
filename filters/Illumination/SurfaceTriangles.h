// SPDX-License-Identifier: BSD-3-Clause
// The triangles that a surface's polygons and strips are made of.
#ifndef SurfaceTriangles_h
#define SurfaceTriangles_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

/// The triangles alone, of valid cells (RequireValidCells), wound as their cells are.
/// @param normals Point normals to keep, or null.
vtkSmartPointer<vtkPolyData> Triangles(vtkPolyData* data, vtkDataArray* normals);

/// For each triangle the cell it comes from, for each point the one of the input; they survive
/// filters that split points.
std::vector<vtkIdType> CellsOfTriangles(vtkPolyData* triangles);
std::vector<vtkIdType> PointsOfTriangles(vtkPolyData* triangles);

#endif
