// SPDX-License-Identifier: BSD-3-Clause
#ifndef RefinedBlocks_h
#define RefinedBlocks_h

#include "Illumination/refinement/RefinedPoints.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace Illumination
{

/// All blocks, each with its facets in parts and its arrays on them, in the order of the blocks.
/// Cells without a part in the mesh are left as they are, after the parts. Adds the arrays
/// OriginalPointIds and OriginalCellIds.
/// @param pointOfFine If given, gets the block's point for each point of the fine mesh, -1 for
/// none.
std::vector<vtkSmartPointer<vtkPolyData>> RefinedBlocks(const RefinementBlocks& blocks,
  const PhotonTransport::RefinedMesh& fine, std::vector<vtkIdType>* pointOfFine = nullptr);

} // namespace Illumination

#endif
