// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceExchange_h
#define PieceExchange_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace Illumination
{

class ControllerRanks;

/// Which block of a data object a piece belongs to: the way there from the top of a composite data
/// set. The partitions of a vtkPartitionedDataSet are pieces of one block.
using BlockPath = std::vector<int>;

/// The part of a block that one rank has.
struct Piece
{
  BlockPath path;
  std::string name; ///< Of the data on their rank, for messages: " of block 2", or "".
  vtkSmartPointer<vtkDataObject> data;
  std::size_t rank = 0;
};

/// The leaves of a data object. @param root The beginning of their paths.
std::vector<Piece> PiecesOf(vtkDataObject* data, const BlockPath& root);

/// The pieces of all ranks, in the order of the ranks, and the same on each of them. Of data that
/// are no surface only the type arrives. Throws InputError if this rank's own surfaces can't be
/// sent because they contradict themselves.
std::vector<Piece> PiecesOfAllRanks(ControllerRanks& ranks, const std::vector<Piece>& own);

} // namespace Illumination

#endif
