// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellValues_h
#define CellValues_h

#include "vtkType.h"

#include <string>

class vtkDataArray;
struct SceneBlock;

/// What the values of a cell array mean and how large they may be; none may be below 0.
struct CellValueKind
{
  const char* what;
  double largest;
};

/// One number for each cell of a block: a constant, or the mean over the components of an array.
class CellValues
{
public:
  explicit CellValues(double constant)
    : Constant(constant)
  {
  }

  /// Throws InputError if the block has no numeric cell array of that name with 1 or 3 components,
  /// one tuple a cell, and all values within [0, kind.largest].
  CellValues(const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind);

  float Of(vtkIdType cell) const;

private:
  double Constant = 0.0;
  vtkDataArray* Array = nullptr;
};

#endif
