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

} // namespace Illumination

#endif
