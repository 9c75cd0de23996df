// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleOrder_h
#define TriangleOrder_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace Illumination
{

/// The triangles in an order that their places alone decide, so that a map has the same bits
/// however a surface is divided between ranks: along a space-filling curve (Morton, "A computer
/// oriented geodetic data base and a new technique in file sequencing", 1966), which also keeps
/// near what is near in the scene. Triangles in one place are told apart by their normals and by
/// the cell arrays of the data. Points come in the order in which triangles use them; unused ones
/// are left out.
/// @param mesh See SurfaceTriangles; its points are finite. @param data That its cells are of.
vtkSmartPointer<vtkPolyData> OrderedByPlace(vtkPolyData* mesh, vtkPolyData* data);

} // namespace Illumination

#endif
