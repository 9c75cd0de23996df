// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChosenBlocks_h
#define ChosenBlocks_h

#include "Illumination/surface/SurfaceParts.h"

#include <set>
#include <vector>

namespace Illumination
{

/// A surface, and whether the user has chosen it.
struct ChosenBlock : NamedSurface
{
  bool chosen;
};

/// All surfaces of a data object, in the order of PartsOf. Flat indices number the nodes of a tree
/// of blocks from the root, 0, each before those below it; empty ones count too.
/// @param data A vtkPolyData, which is always chosen, or a tree of blocks.
/// @param chosen Flat indices of blocks, each with all blocks below it. If empty, all are chosen.
/// Throws InputError for an index that no block has, and if no chosen block is a surface.
std::vector<ChosenBlock> ChooseBlocks(vtkDataObject* data, const std::set<int>& chosen);

} // namespace Illumination

#endif
