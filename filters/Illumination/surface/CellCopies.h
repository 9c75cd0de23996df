// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellCopies_h
#define CellCopies_h

#include "vtkType.h"

#include <vector>

class vtkCellArray;

namespace Illumination
{

/// For each cell the first one with the same corners in the same order but for their start.
std::vector<vtkIdType> FirstOfCopies(vtkCellArray* cells);

/// Gives copies of polygons the corners of the first, from the same start, or a square could be cut
/// along its other diagonal.
void StartCopiesAlike(vtkCellArray* cells);

} // namespace Illumination

#endif
