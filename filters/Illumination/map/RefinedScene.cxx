// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/RefinedScene.h"

#include "Illumination/map/SceneBlocks.h"
#include "Illumination/refinement/RefinedBlocks.h"

#include "vtkPolyData.h"

#include <utility>

namespace Illumination
{
namespace
{

/// Which vertex of the refined mesh each point of a block has, where it is not a ghost point.
class OwnVertices
{
public:
  OwnVertices(const SceneBlock& block, const std::vector<vtkIdType>& pointOfFine)
    : Block(block)
    , PointOfFine(pointOfFine)
    , Found(pointOfFine.size(), false)
  {
  }

  void Add(std::size_t vertex)
  {
    const auto point = static_cast<std::size_t>(this->PointOfFine[vertex]);
    const bool borrows = point < this->Block.borrows.size() && this->Block.borrows[point];
    if (!this->Found[vertex] && !borrows)
    {
      this->Vertices.push_back({ vertex, point });
    }
    this->Found[vertex] = true;
  }

  std::vector<BorrowedVertex> Vertices;

private:
  const SceneBlock& Block;
  const std::vector<vtkIdType>& PointOfFine;
  std::vector<bool> Found;
};

} // namespace

std::vector<SceneBlock> RefineBlocks(
  const SceneBlocks& blocks, const PhotonTransport::RefinedMesh& mesh)
{
  std::vector<vtkIdType> pointOfFine;
  const auto surfaces =
    RefinedBlocks(RefinementBlocks(blocks.Surface(), blocks.Blocks()), mesh, &pointOfFine);
  std::vector<SceneBlock> refined;
  std::size_t facet = 0;
  for (const SceneBlock& block : blocks.Blocks())
  {
    OwnVertices own(block, pointOfFine);
    for (std::size_t v = 0; v < block.pointOfVertex.size(); ++v)
    {
      own.Add(block.firstVertex + v);
    }
    const std::size_t end = block.firstFacet + block.cellOfFacet.size();
    for (; facet < mesh.facets.size() && mesh.origins[facet].facet < end; ++facet)
    {
      for (int c = 0; c < 3; ++c)
      {
        own.Add(mesh.facets[facet][c]);
      }
    }
    block.data->ShallowCopy(surfaces[refined.size()]);
    SceneBlock fine(block);
    fine.pointOfVertex.clear();
    fine.borrowed = std::move(own.Vertices);
    fine.borrowed.insert(fine.borrowed.end(), block.borrowed.begin(), block.borrowed.end());
    refined.push_back(std::move(fine));
  }
  return refined;
}

} // namespace Illumination
