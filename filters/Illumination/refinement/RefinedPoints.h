// SPDX-License-Identifier: BSD-3-Clause
#ifndef RefinedPoints_h
#define RefinedPoints_h

#include "Illumination/refinement/RefinementBlocks.h"

#include "PhotonTransport/refinement/Refinement.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace Illumination
{

/// The parts of a block's facets: facets of the fine mesh from `first` to before `end`.
struct FinePart
{
  const PhotonTransport::TriangleMesh& mesh;
  const PhotonTransport::RefinedMesh& fine;
  std::size_t first;
  std::size_t end;
};

/// A point that is added to a block's own.
struct AddedPoint
{
  glm::dvec3 place;
  std::array<std::size_t, 3> vertices; ///< Of the mesh, that have a share in the point's values.
  glm::dvec3 weights;                  ///< Their shares, >= 0, together 1.
  bool isCopy;                         ///< Of a point of the block.

  /// The vertex with the greatest share, of several the one with the least number, so that all
  /// facets of an edge agree.
  std::size_t Nearest() const;
};

/// The points of a refined block: its own, unmoved, then copies of them where normals were split,
/// then new ones.
class RefinedPoints
{
public:
  /// @param idOfFinePoint One for each point of the fine mesh; those of the block are filled in.
  RefinedPoints(
    const RefinementBlock& block, const FinePart& part, std::vector<vtkIdType>& idOfFinePoint);

  /// How many points the block itself has; the added ones come next.
  vtkIdType NumberGiven() const { return this->Given; }
  vtkIdType Number() const { return this->Given + static_cast<vtkIdType>(this->Points.size()); }
  const std::vector<AddedPoint>& Added() const { return this->Points; }

private:
  vtkIdType Add(const AddedPoint& point);

  vtkIdType Given;
  std::vector<AddedPoint> Points;
};

} // namespace Illumination

#endif
