// SPDX-License-Identifier: BSD-3-Clause
#ifndef GhostPoints_h
#define GhostPoints_h

#include "Illumination/surface/SurfaceParts.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace Illumination
{

/// A point that is a copy of another point, its owner. It gets the owner's value.
struct GhostPoint
{
  vtkIdType point;
  std::size_t ownerBlock;
  vtkIdType owner;
};

/// The ghost points of a block.
struct GhostPoints
{
  std::vector<GhostPoint> owned;
  /// Ghost points that no cell of the scene uses and whose owner is not in the input: they get no
  /// light.
  std::size_t ownerless = 0;
  vtkIdType firstOwnerless = -1; ///< Point id.
};

/// Finds the ghost points of each block and their owners. A ghost point is marked as a duplicate by
/// the point array vtkGhostType, or used by duplicate cells only (GhostCells::IsCopy). Its owner is
/// a point of the scene that is no ghost point, in the same place up to the rounding of single
/// precision, and faces the same way. The result is empty if no block has an array vtkGhostType.
/// @param blocks Their cells must be valid.
std::vector<GhostPoints> FindGhostPoints(const std::vector<NamedSurface>& blocks);

} // namespace Illumination

#endif
