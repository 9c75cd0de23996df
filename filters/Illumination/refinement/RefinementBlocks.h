// SPDX-License-Identifier: BSD-3-Clause
#ifndef RefinementBlocks_h
#define RefinementBlocks_h

#include "Illumination/surface/SceneBlock.h"
#include "Illumination/surface/SurfaceParts.h"

#include "PhotonTransport/refinement/MeshEdges.h"
#include "PhotonTransport/scene/Surface.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace Illumination
{

/// One vtkPolyData of a surface that is to be refined, and where its parts went in the mesh.
struct RefinementBlock : NamedSurface
{
  vtkDataArray* givenNormals; ///< Null: they were computed.
  std::size_t firstVertex;
  std::size_t firstFacet;
  /// The mesh has the points of the block, some of them twice where normals were split.
  std::vector<vtkIdType> pointOfVertex;
  std::vector<vtkIdType> cellOfFacet;
};

/// All polygonal blocks of a data object as one mesh, so that facets of two blocks that share an
/// edge are divided alike. Cells that are hidden or that finer cells replace are no part of it.
/// Duplicates of other blocks' cells are: their edges then divide as their originals' do.
class RefinementBlocks
{
public:
  /// Throws InputError. @param data A vtkPolyData or a composite data set; must outlive this.
  /// @param featureAngle Degrees, for blocks without normals; see WithNormals.
  RefinementBlocks(vtkDataObject* data, double featureAngle);
  /// The blocks of a scene. Duplicates of other blocks' cells are no part of it.
  /// @param surface That of the blocks, as it was given.
  RefinementBlocks(const PhotonTransport::Surface& surface, const std::vector<SceneBlock>& blocks);

  PhotonTransport::TriangleMesh Mesh() const
  {
    return { this->Points, this->Normals, this->Facets, this->Rounding };
  }
  const std::vector<RefinementBlock>& Blocks() const { return this->Parts; }

private:
  void Append(const NamedSurface& part, double featureAngle);

  std::vector<RefinementBlock> Parts;
  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<glm::uvec3> Facets;
  double Rounding = 0.0; ///< See Surface::rounding.
};

} // namespace Illumination

#endif
