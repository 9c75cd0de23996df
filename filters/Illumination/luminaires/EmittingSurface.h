// SPDX-License-Identifier: BSD-3-Clause
#ifndef EmittingSurface_h
#define EmittingSurface_h

#include "PhotonTransport/lights/Lamp.h"

#include <optional>

class vtkPolyData;

namespace Illumination
{

/// A surface with the cell array "Exitance" (lm/m^2, >= 0, 1 component or 3) as EmittingMesh. Its
/// triangles shine to the side of their point normals, or, if it has none, to the side round which
/// they wind counter-clockwise. The mesh has one colour, which is the mean over all its light. A
/// field array LuminaireName (text) gives its name. Nothing for a surface without the array. Throws
/// InputError for cells, points, normals and values that can't be used, and for a surface without a
/// triangle that has an area.
std::optional<PhotonTransport::Luminaire> ReadEmittingSurface(vtkPolyData* data);

} // namespace Illumination

#endif
