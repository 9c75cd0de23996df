// SPDX-License-Identifier: BSD-3-Clause
#ifndef MergedPieces_h
#define MergedPieces_h

#include "Illumination/ranks/PieceExchange.h"

#include "vtkType.h"

class vtkPolyData;

namespace Illumination
{

/// The pieces of one block, put together.
struct MergedPieces
{
  /// The polygons and strips of all pieces with their arrays, in the order of the pieces, and with
  /// the arrays of PieceNames.h.
  vtkSmartPointer<vtkPolyData> data;
  /// [piece][point] The point of `data`.
  std::vector<std::vector<vtkIdType>> pointOf;
};

/// Puts pieces together. Points that were one before the surface was divided become one again:
/// points of different pieces in the same place with the same normal and the same values in all
/// other arrays of real numbers. Where one piece has several such points none of them is merged,
/// since what belongs together can't be told. Global point ids, where all pieces have them, decide
/// alone.
///
/// Throws InputError for a piece that has cells, but not the arrays of the others.
/// @param pieces Of one block; there is at least one. All are vtkPolyData.
MergedPieces Merge(const std::vector<Piece>& pieces);

} // namespace Illumination

#endif
