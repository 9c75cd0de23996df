// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellValues_h
#define CellValues_h

#include "PhotonTransport/materials/Colour.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
struct SceneBlock;

/// What the values of a cell array mean and how large they may be. None may be below 0.
struct CellValueKind
{
  const char* what; ///< For messages, such as "exitance".
  double largest;
  bool colours = true; ///< Whether the array may have three components.
};

/// A colour for each cell of a block: a constant, or the value of an array. One component is grey.
class CellValues
{
public:
  explicit CellValues(const PhotonTransport::Colour& constant)
    : Constant(constant)
  {
  }

  /// Throws InputError unless the block has a numeric cell array of that name with 1 or, where
  /// kind.colours, 3 components and one tuple a cell, and all values of cells that have a facet are
  /// within [0, kind.largest].
  CellValues(const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind);

  PhotonTransport::Colour Of(vtkIdType cell) const;

private:
  PhotonTransport::Colour Constant{ 0.0f };
  vtkDataArray* Array = nullptr;
};

#endif
