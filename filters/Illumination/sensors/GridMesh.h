// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridMesh_h
#define GridMesh_h

#include "PhotonTransport/sensors/SensorGrid.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace Illumination
{

/// The triangles of all polygons and strips of a vtkPolyData or of the blocks of a composite data
/// set. Throws InputError as TrianglesOf does, and if there are none.
std::vector<PhotonTransport::AreaTriangle> TrianglesOfAll(vtkDataObject* data);

/// A grid as a surface that can be drawn: quadrilaterals between sensors that are neighbours, and
/// vertices where a sensor has none. The points have normals and the array SensorArea, m^2.
void FillMesh(const PhotonTransport::SensorGrid& grid, vtkPolyData* mesh);

} // namespace Illumination

#endif
