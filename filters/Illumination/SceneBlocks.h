// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneBlocks_h
#define SceneBlocks_h

#include "SurfaceTriangles.h"

#include "PhotonTransport/scene/Surface.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <stdexcept>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// Thrown for input that can't be used; what() is the whole message for the user.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A vertex of the scene whose values a ghost point gets as well.
struct BorrowedVertex
{
  std::size_t vertex; ///< Of the scene.
  std::size_t point;  ///< Of the block.
};

/// One vtkPolyData of the scene and where its parts went in the Surface.
struct SceneBlock
{
  vtkPolyData* data = nullptr; ///< Points and cells of this block.
  std::string name;            ///< " of block 2", or "" where there is only one.
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

/// What the arrays and properties say about the surface.
struct SurfaceDescription
{
  PhotonTransport::Material material; ///< Where no array says otherwise.
  std::string reflectanceArray;       ///< Empty: DiffuseReflectance, where materialArrays.
  bool materialArrays = true;         ///< Whether arrays with the names of MaterialArrays count.
  std::string exitanceArray;          ///< Empty: nothing emits.
  double metresPerUnit = 1.0;
  double featureAngle = 30.0; ///< Degrees.
};

/// All polygonal blocks of a data object as one Surface.
class SceneBlocks
{
public:
  /// Throws InputError. @param data A vtkPolyData or a composite data set; must outlive this.
  SceneBlocks(vtkDataObject* data, const SurfaceDescription& description);

  const PhotonTransport::Surface& Surface() const { return this->All; }
  /// All blocks with polygons or strips; those without a triangle in the scene come last.
  const std::vector<SceneBlock>& Blocks() const { return this->Parts; }
  std::size_t BlocksNotPolygonal() const { return this->OtherBlocks; }

  /// "cell 7 of block 2": a facet or vertex of the surface in the user's terms.
  std::string NameOfFacet(std::size_t facet) const;
  std::string NameOfVertex(std::size_t vertex) const;

private:
  void Append(SceneBlock block, const SurfaceDescription& description);
  void AddVertices(vtkPolyData* mesh);
  void AddFacets(vtkPolyData* mesh, std::size_t firstVertex);
  void AddExitance(const SceneBlock& block, const std::string& array);
  void AppendUnlit();
  void LendVertices();

  PhotonTransport::Surface All;
  std::vector<SceneBlock> Parts;
  std::vector<SceneBlock> Unlit; ///< Blocks without a triangle, until they are put last.
  std::size_t OtherBlocks = 0;
};

#endif
