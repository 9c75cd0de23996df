// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonCutter_h
#define PolygonCutter_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace Illumination
{

/// Cuts polygons into the triangles that vtkTriangleFilter makes of them, in its order, but on all
/// threads. Points and their arrays are those of the input, and a triangle has its polygon's values
/// of one array of cells.
/// @param mesh Has no cells but polygons; they have three corners at least.
/// @param cellArray The name of a vtkIdTypeArray of its cells.
vtkSmartPointer<vtkPolyData> CutPolygons(vtkPolyData* mesh, const char* cellArray);

} // namespace Illumination

#endif
