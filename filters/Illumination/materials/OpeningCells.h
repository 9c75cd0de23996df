// SPDX-License-Identifier: BSD-3-Clause
// The cell array Opening: 1 for an opening through which outdoor light enters, 0 for none, -1 where
// the mesh is to tell, as where there is no array.
#ifndef OpeningCells_h
#define OpeningCells_h

#include "Illumination/surface/SceneBlock.h"
#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/scene/Surface.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace Illumination
{

/// Gives the facets of all blocks their marks, if any block has the array and arrays count. Throws
/// InputError, which names cell and value, for an array that is not one number a cell, or for
/// another value.
void DescribeOpenings(const std::vector<SceneBlock>& blocks, const SurfaceDescription& description,
  PhotonTransport::Surface& surface);

/// Writes the array. The chosen cells (one flag a cell) get the mark; the others keep what they
/// have, or -1. Nothing is written if the mark is None and there is no array. The array is replaced
/// and never changed, since it may be shared with the input. Throws InputError as above, also for a
/// cell that is not chosen, unless it is a ghost. @param block How messages name the data: " of
/// block 2", or "".
void WriteOpening(vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen,
  PhotonTransport::OpeningMark mark);

} // namespace Illumination

#endif
