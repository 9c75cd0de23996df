// SPDX-License-Identifier: BSD-3-Clause
#ifndef SharedPoints_h
#define SharedPoints_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace Illumination
{

struct PointOfPiece
{
  std::size_t piece;
  vtkIdType point;
};

/// Which points of pieces are one point of the whole.
struct SharedPoints
{
  /// [piece][point] The point of the whole.
  std::vector<std::vector<vtkIdType>> numbers;
  /// [point of the whole] The first point of a piece that it is.
  std::vector<PointOfPiece> origins;
};

/// See Merge in MergedPieces.h for the rule.
SharedPoints FindSharedPoints(const std::vector<vtkPolyData*>& surfaces);

} // namespace Illumination

#endif
