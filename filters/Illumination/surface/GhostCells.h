// SPDX-License-Identifier: BSD-3-Clause
#ifndef GhostCells_h
#define GhostCells_h

#include "vtkType.h"

#include <string>

class vtkPolyData;
class vtkUnsignedCharArray;

namespace Illumination
{

/// Which cells of a block are not part of the scene by the cell array vtkGhostType: duplicates of
/// another block's cells, cells that finer cells replace, and hidden cells. VTK's own filters and
/// renderers leave them out, too.
class GhostCells
{
public:
  /// Throws InputError for an array whose size does not fit the cells. An array of another type
  /// than unsigned char is ignored, as VTK does. @param block How messages name the data: " of
  /// block 2", or "".
  GhostCells(vtkPolyData* data, const std::string& block);

  bool Any() const { return this->Flags != nullptr; }
  bool IsGhost(vtkIdType cell) const;
  /// Whether the cell is a duplicate of another block's cell, and neither replaced nor hidden.
  bool IsCopy(vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Flags;
};

/// The point array vtkGhostType; null if there is none. Throws InputError if its size does not fit
/// the points.
vtkUnsignedCharArray* GhostPointFlags(vtkPolyData* data, const std::string& block);

} // namespace Illumination

#endif
