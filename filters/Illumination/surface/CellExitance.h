// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellExitance_h
#define CellExitance_h

#include "Illumination/surface/SurfaceParts.h"

#include "PhotonTransport/materials/Colour.h"

#include "vtkType.h"

namespace Illumination
{

/// What each of the cells shines with, lm/m^2, by a cell array of 1 component (white) or 3. Throws
/// InputError if there is no such array of numbers, or for a value below 0 or not finite.
std::vector<PhotonTransport::Colour> ExitanceOf(
  const NamedSurface& block, const std::string& array, const std::vector<vtkIdType>& cells);

} // namespace Illumination

#endif
