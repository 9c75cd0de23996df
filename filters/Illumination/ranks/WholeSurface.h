// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeSurface_h
#define WholeSurface_h

#include "Illumination/ranks/MergedPieces.h"
#include "Illumination/ranks/PieceExchange.h"
#include "Illumination/ranks/PieceResults.h"

#include <functional>
#include <vector>

class vtkPolyData;

namespace Illumination
{

/// One block with what all ranks have of it.
struct WholeBlock
{
  std::vector<Piece> pieces;
  MergedPieces merged; ///< Empty unless the block is a vtkPolyData that was put together.
  vtkSmartPointer<vtkDataObject> data;
};

/// Data of which ranks have parts, put together on each of them: of the type and structure that
/// this rank's data have. The partitions of a block are one.
class WholeSurface
{
public:
  /// A block that is not divided: the first rank's that has it counts.
  using IsWhole = std::function<bool(vtkPolyData* block)>;

  /// All ranks must call it. Throws InputError.
  WholeSurface(ControllerRanks& ranks, vtkDataObject* own, const IsWhole& isWhole = {});

  vtkDataObject* Data() const { return this->Whole; }

  /// Gives this rank's data what a filter has added to Data(), or made of it.
  /// @param own Of the structure of the data that were put together.
  void PutResults(vtkDataObject* own, std::size_t rank) const;

private:
  std::vector<WholeBlock> Blocks;
  vtkSmartPointer<vtkDataObject> Whole;
  ArraysBefore Before;
};

} // namespace Illumination

#endif
