// SPDX-License-Identifier: BSD-3-Clause
#ifndef GhostPoints_h
#define GhostPoints_h

#include "Illumination/surface/SurfaceParts.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

/// A point that is a copy of another one, its owner, whose value it gets.
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
  std::size_t ownerless = 0;     ///< Those whose owner is not in the input and which get no light.
  vtkIdType firstOwnerless = -1; ///< Point id.
};

/// The points of each block that vtkGhostType marks as copies, or that only cells use which it
/// marks as such (GhostCells), with their owners: points that are no copies, of a surface in the
/// same place that faces the same way. Positions are the same up to the rounding of single
/// precision. Nothing is found where there is no vtkGhostType; the result is then empty.
/// @param blocks Their cells must be valid.
std::vector<GhostPoints> FindGhostPoints(const std::vector<NamedSurface>& blocks);

#endif
