// SPDX-License-Identifier: BSD-3-Clause
// Point normals where the input has none.
#ifndef ComputedNormals_h
#define ComputedNormals_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace Illumination
{

/// Triangles with normals, their points split at edges sharper than the feature angle (degrees).
///
/// Copies of triangles, which have the same corners and wind the same way, get the points of the
/// first. VTK's filter does not see them: at an edge of more than two triangles it splits points,
/// or turns one of two that run along the edge the same way.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* triangles, double featureAngle);

} // namespace Illumination

#endif
