// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneBlocks_h
#define SceneBlocks_h

#include "Illumination/surface/SceneBlock.h"
#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/Surface.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace Illumination
{

/// All polygonal blocks of a data object as one Surface.
class SceneBlocks
{
public:
  /// Throws InputError. @param data A vtkPolyData or a composite data set; must outlive this.
  SceneBlocks(vtkDataObject* data, const SurfaceDescription& description);

  /// From now on the blocks are those of another data object, of the same cells and points, which
  /// must outlive this, too.
  void LieIn(vtkDataObject* data);

  const PhotonTransport::Surface& Surface() const { return this->All; }
  /// All blocks with polygons or strips; those without a triangle in the scene come last.
  const std::vector<SceneBlock>& Blocks() const { return this->Parts; }
  std::size_t BlocksNotPolygonal() const { return this->OtherBlocks; }

  /// "cell 7 of block 2": a facet or vertex of the surface in the user's terms.
  std::string NameOfFacet(std::size_t facet) const;
  std::string NameOfVertex(std::size_t vertex) const;
  /// The core's complaint with the user's name for the place.
  std::string WordsFor(const PhotonTransport::InvalidInput& error) const;

private:
  void Append(SceneBlock block, const SurfaceDescription& description);
  void AppendUnlit();
  void LendVertices();

  PhotonTransport::Surface All;
  std::vector<SceneBlock> Parts;
  std::vector<SceneBlock> Unlit; ///< Blocks without a triangle, until they are put last.
  std::size_t OtherBlocks = 0;
};

} // namespace Illumination

#endif
