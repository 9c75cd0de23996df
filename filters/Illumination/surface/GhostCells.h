// SPDX-License-Identifier: BSD-3-Clause
#ifndef GhostCells_h
#define GhostCells_h

#include "vtkType.h"

#include <string>

class vtkPolyData;
class vtkUnsignedCharArray;

/// Which cells of a block the cell array vtkGhostType takes out of it, as VTK's own filters and
/// renderers do: copies of another block's cells, cells that finer ones stand for, hidden ones.
class GhostCells
{
public:
  /// Throws InputError for an array that does not fit the cells; one that does not hold unsigned
  /// chars is no such array to VTK, and none here. @param block As messages name it.
  GhostCells(vtkPolyData* data, const std::string& block);

  bool Any() const { return this->Flags != nullptr; }
  bool IsGhost(vtkIdType cell) const;
  /// A copy of another block's cell, which may be found there.
  bool IsCopy(vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Flags;
};

/// The array vtkGhostType of the points; null if there is none. Throws InputError as above.
vtkUnsignedCharArray* GhostPointFlags(vtkPolyData* data, const std::string& block);

#endif
