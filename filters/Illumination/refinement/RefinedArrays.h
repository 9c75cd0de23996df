// SPDX-License-Identifier: BSD-3-Clause
#ifndef RefinedArrays_h
#define RefinedArrays_h

#include "Illumination/refinement/RefinedPoints.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkPointData;

namespace Illumination
{

/// Puts the point arrays of a block onto its refined points.
///  - Numbers with a fraction, and colours of 8 bits, are interpolated linearly between the corners
///    of the facet that a new point is in. Normals then get unit length.
///  - Whole numbers and text are those of the nearest corner.
///  - A new point has the ghost flags that all corners have.
///  - Global ids are left out, since each may be there only once.
/// @param normals Of the mesh. They become the point array Normals where a block had none.
void AddPointArrays(const RefinementBlock& block, const RefinedPoints& points,
  const std::vector<glm::dvec3>& normals, vtkPointData* result);

} // namespace Illumination

#endif
