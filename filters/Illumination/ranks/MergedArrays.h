// SPDX-License-Identifier: BSD-3-Clause
#ifndef MergedArrays_h
#define MergedArrays_h

#include "Illumination/ranks/PieceExchange.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace Illumination
{

/// " of block 2 on rank 1", for messages.
std::string NameOf(const Piece& piece);

/// Which tuples of a piece go where in the whole.
struct TuplePlaces
{
  std::vector<vtkIdType> from, to;
};

/// Copies the point or the cell arrays of pieces to those of the whole. Not every piece marks
/// ghosts, so arrays of ghosts are left out.
class MergedArrays
{
public:
  /// @param tuples Of the whole. @param kind "point" or "cell", for messages.
  MergedArrays(const std::vector<Piece>& pieces, vtkDataSetAttributes* result, vtkIdType tuples,
    const char* kind)
    : Pieces(pieces)
    , Result(result)
    , Tuples(tuples)
    , Kind(kind)
  {
  }

  /// Throws InputError if a piece that has tuples has not the arrays of the others.
  void Add(std::size_t piece, vtkDataSetAttributes* arrays, const TuplePlaces& places);

private:
  void Begin(vtkDataSetAttributes* arrays);
  std::string NameOfArray(const char* array) const;
  void RequireNoOthers(std::size_t piece, vtkDataSetAttributes* arrays) const;
  void RequireAlike(std::size_t piece, vtkAbstractArray* array, vtkAbstractArray* given) const;
  [[noreturn]] void RefuseMissing(const char* array, std::size_t has, std::size_t hasNot) const;

  const std::vector<Piece>& Pieces;
  vtkDataSetAttributes* Result;
  vtkIdType Tuples;
  const char* Kind;
  bool HasFirst = false;
  std::size_t First = 0; ///< The piece that says which arrays there are.
};

} // namespace Illumination

#endif
