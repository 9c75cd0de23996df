// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellValues_h
#define CellValues_h

#include "PhotonTransport/materials/Colour.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
struct SceneBlock;

/// What the values of a cell array mean and how large they may be; none may be below 0.
struct CellValueKind
{
  const char* what;
  double largest;
  bool colours = true; ///< Whether three components will do too.
};

/// A colour for each cell of a block: a constant, or what an array says. One component is grey.
class CellValues
{
public:
  explicit CellValues(const PhotonTransport::Colour& constant)
    : Constant(constant)
  {
  }

  /// Throws InputError if the block has no numeric cell array of that name with 1 or 3 components,
  /// one tuple a cell, and all values within [0, kind.largest].
  CellValues(const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind);

  PhotonTransport::Colour Of(vtkIdType cell) const;

private:
  PhotonTransport::Colour Constant{ 0.0f };
  vtkDataArray* Array = nullptr;
};

#endif
