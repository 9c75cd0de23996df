// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneBlocks_h
#define SceneBlocks_h

#include "InputChecks.h"

#include "PhotonTransport/scene/Surface.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <stdexcept>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// Input that can't be used; what() is the whole message for the user.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
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
  UncutPolygons uncut;
};

/// What the arrays and properties say about the surface.
struct SurfaceDescription
{
  PhotonTransport::Material material; ///< Where no array says otherwise.
  std::string reflectanceArray;       ///< Empty: the array of the usual name, if there is one.
  bool materialArrays = true;         ///< Whether arrays of MaterialArrays' names count.
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
  const std::vector<SceneBlock>& Blocks() const { return this->Parts; }
  std::size_t BlocksNotPolygonal() const { return this->OtherBlocks; }

  /// "cell 7 of block 2": a facet or vertex of the surface in the user's terms.
  std::string NameOfFacet(std::size_t facet) const;
  std::string NameOfVertex(std::size_t vertex) const;

private:
  void Append(SceneBlock block, const SurfaceDescription& description);

  PhotonTransport::Surface All;
  std::vector<SceneBlock> Parts;
  std::size_t OtherBlocks = 0;
};

#endif
