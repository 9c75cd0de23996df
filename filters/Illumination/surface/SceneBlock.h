// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneBlock_h
#define SceneBlock_h

#include "Illumination/surface/SurfaceParts.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace Illumination
{

/// A vertex of the scene whose values a ghost point gets as well.
struct BorrowedVertex
{
  std::size_t vertex; ///< Of the scene.
  std::size_t point;  ///< Of the block.
};

/// One vtkPolyData of the scene and where its parts went in the Surface.
struct SceneBlock : NamedSurface
{
  explicit SceneBlock(const NamedSurface& surface)
    : NamedSurface(surface)
  {
  }

  std::size_t firstVertex = 0;
  std::size_t firstFacet = 0;
  std::vector<vtkIdType> pointOfVertex; ///< A point has more than one where normals were split.
  std::vector<vtkIdType> cellOfFacet;
  bool normalsWereComputed = false;
  LeftOut ghosts;                       ///< See SurfaceTriangles.
  LeftOut withoutArea;                  ///< See SurfaceTriangles.
  LeftOut uncut;                        ///< See SurfaceTriangles.
  std::vector<BorrowedVertex> borrowed; ///< Of the block's ghost points.
  std::vector<bool> borrows;            ///< Which points have a borrowed one; or empty.
  std::size_t ownerlessGhosts = 0;      ///< GhostPoints::ownerless.
  vtkIdType firstOwnerlessGhost = -1;
};

} // namespace Illumination

#endif
