// SPDX-License-Identifier: BSD-3-Clause
#ifndef AccuracyRegion_h
#define AccuracyRegion_h

#include <set>
#include <string>
#include <vector>

class vtkDataObject;

namespace Illumination
{

class SceneBlocks;

/// Where accuracy counts: in the chosen blocks, in the cells whose value in the array is not 0.
struct RegionChoice
{
  std::string array;    ///< Of cells; empty for all cells of the blocks.
  std::set<int> blocks; ///< Flat indices, see ChooseBlocks; empty for all blocks.

  bool IsEmpty() const { return this->array.empty() && this->blocks.empty(); }
};

/// [vertex] The share of each vertex's area that belongs to the region, [0, 1]; nothing if the
/// choice is empty. Blocks without the array are not in the region. Throws InputError as
/// ChooseBlocks does, if no chosen block has such an array of one number a cell, for NaN, and if no
/// cell is in the region.
/// @param data Of which the scene's blocks were made.
std::vector<double> AccuracyRegion(
  const SceneBlocks& blocks, vtkDataObject* data, const RegionChoice& choice);

} // namespace Illumination

#endif
