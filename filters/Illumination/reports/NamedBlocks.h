// SPDX-License-Identifier: BSD-3-Clause
#ifndef NamedBlocks_h
#define NamedBlocks_h

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace Illumination
{

/// A data set with points.
struct NamedBlock
{
  vtkDataSet* data;
  std::string where; ///< For messages: " of block 2", or "".
  /// Of the block; the partitions of a collection's data set have the number of that.
  double number;
  std::string name; ///< Its own, or "Block 2"; "All" where there are no blocks.
};

struct NamedBlocks
{
  std::vector<NamedBlock> blocks;
  std::size_t others = 0; ///< Blocks that are no data sets.

  /// Adds the blocks of a data set or of a composite data set, which must outlive this.
  void Add(vtkDataObject* data);
};

} // namespace Illumination

#endif
