// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceResults_h
#define PieceResults_h

#include "Illumination/ranks/MergedPieces.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

#include <set>

class vtkFieldData;
class vtkPolyData;

namespace Illumination
{

/// Arrays that no filter has added. They are kept alive: one that is made later could otherwise
/// have the address of one that is gone.
using ArraysBefore = std::set<vtkSmartPointer<vtkAbstractArray>>;

/// Brings what a filter has made of pieces that were put together back to the pieces.
class PieceResults
{
public:
  /// @param before Arrays that are no result.
  explicit PieceResults(const ArraysBefore& before)
    : Before(before)
  {
  }

  /// Adds the new arrays to a piece, or, where the filter has refined the surface (RefinedBlocks),
  /// gives the piece the parts of its own cells.
  /// @param own The piece as it was.
  void Put(const MergedPieces& merged, std::size_t piece, vtkPolyData* own) const;

  /// Adds new field data, which are those of the whole.
  void AddFields(vtkFieldData* whole, vtkFieldData* own) const;

private:
  bool IsNew(vtkAbstractArray* array) const { return this->Before.count(array) == 0; }

  const ArraysBefore& Before;
};

} // namespace Illumination

#endif
