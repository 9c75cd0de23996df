// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

struct Point
{
  double x, y, z;
};

struct Cell
{
  std::vector<vtkIdType> corners;
  double reflectance;
};

/// A mesh that can be changed before VTK gets it.
struct Mesh
{
  std::vector<Point> points;
  std::vector<Point> normals; ///< Of the first points; the others have that of the last.
  std::vector<Cell> polygons;
  std::vector<Cell> strips;
  std::vector<std::vector<vtkIdType>> rows; ///< Points that lie on a line, before rounding.

  /// With the cell array "rho". @param single Whether coordinates are in single precision.
  vtkSmartPointer<vtkPolyData> Data(bool single, bool withNormals) const;
};

/// A closed box around the origin, turned at random, its edges shared by two walls, of triangles
/// and quadrilaterals in a random order that wind to look inside.
Mesh RandomRoom(unsigned seed);
