// SPDX-License-Identifier: BSD-3-Clause
#ifndef EmittingSurface_h
#define EmittingSurface_h

#include "PhotonTransport/lights/Lamp.h"

#include <optional>

class vtkPolyData;

/// A surface with the cell array "Exitance" (lm/m^2, >= 0, 1 component or 3) as EmittingMesh: its
/// triangles shine to the side of their point normals, or, without any, to the side round which
/// they wind counter-clockwise. The mesh has one colour, the mean over its light. Nothing for a
/// surface without the array. A field array LuminaireName (text) names it. Throws InputError for
/// cells, points and values that can't be used.
std::optional<PhotonTransport::Luminaire> ReadEmittingSurface(vtkPolyData* data);

#endif
