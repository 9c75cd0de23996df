// SPDX-License-Identifier: BSD-3-Clause
#ifndef NamedBlocks_h
#define NamedBlocks_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace Illumination
{

/// A data set with points.
struct NamedBlock
{
  vtkSmartPointer<vtkDataSet> data;
  std::string where; ///< For messages: " of block 2", or "".
  /// Of the block; the partitions of a collection's data set have the number of that.
  double number;
  std::string name;     ///< Its own, or "Block 2"; "All" where there are no blocks.
  std::size_t rank = 0; ///< Which has it.
};

struct NamedBlocks
{
  std::vector<NamedBlock> blocks;
  std::size_t others = 0; ///< Blocks that are no data sets.

  /// Adds the blocks of a data set or of a composite data set.
  void Add(vtkDataObject* data, std::size_t rank);

  /// Makes one block of surfaces that have one number and are on several ranks, so that points on
  /// the borders between these count once, see Merge. Throws InputError.
  void JoinSurfacesOfRanks();
};

} // namespace Illumination

#endif
