// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/WholeSurface.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/PieceResults.h"
#include "Illumination/ranks/TreeChildren.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>

namespace Illumination
{
namespace
{

using BlocksByPath = std::map<BlockPath, WholeBlock>;

void PutTogether(WholeBlock& block, const WholeSurface::IsWhole& isWhole)
{
  const std::vector<Piece>& pieces = block.pieces;
  const auto isSurface = [](const Piece& piece)
  { return vtkPolyData::SafeDownCast(piece.data) != nullptr; };
  const auto other = std::find_if_not(pieces.begin(), pieces.end(), isSurface);
  if (other != pieces.end())
  {
    const auto surface = std::find_if(pieces.begin(), pieces.end(), isSurface);
    if (surface != pieces.end())
    {
      throw InputError("the data" + surface->name + " are a vtkPolyData on rank " +
        std::to_string(surface->rank) + " and a " + other->data->GetClassName() + " on rank " +
        std::to_string(other->rank));
    }
    block.data = other->data;
    return;
  }
  const auto whole = std::find_if(pieces.begin(), pieces.end(),
    [&](const Piece& piece) { return isWhole && isWhole(vtkPolyData::SafeDownCast(piece.data)); });
  if (whole != pieces.end())
  {
    block.data = whole->data;
    return;
  }
  block.merged = Merge(pieces);
  block.data = block.merged.data;
}

/// Puts blocks in their places below a node.
/// @param like The node of this rank's data. @param used Gets the paths of blocks that have a
/// place.
void Fill(vtkDataObjectTree* like, vtkDataObjectTree* node, const BlockPath& path,
  const BlocksByPath& blocks, std::set<BlockPath>& used)
{
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(node))
  {
    const auto found = blocks.find(path);
    partitions->SetNumberOfPartitions(found != blocks.end() ? 1 : 0);
    if (found != blocks.end())
    {
      partitions->SetPartition(0, found->second.data);
      used.insert(path);
    }
    return;
  }
  ForEachChild(like,
    [&](vtkDataObjectTreeIterator* it, int child)
    {
      BlockPath below = path;
      below.push_back(child);
      const auto found = blocks.find(below);
      if (auto* tree = vtkDataObjectTree::SafeDownCast(it->GetCurrentDataObject()))
      {
        Fill(tree, vtkDataObjectTree::SafeDownCast(node->GetDataSet(it)), below, blocks, used);
      }
      else if (found != blocks.end())
      {
        node->SetDataSet(it, found->second.data);
        used.insert(below);
      }
    });
}

/// Blocks in the structure of this rank's data.
vtkSmartPointer<vtkDataObject> Assembled(vtkDataObject* own, const BlocksByPath& blocks)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(own);
  std::set<BlockPath> used;
  vtkSmartPointer<vtkDataObject> whole;
  if (!composite)
  {
    const auto found = blocks.find(BlockPath());
    whole = found != blocks.end() ? found->second.data : vtkSmartPointer<vtkDataObject>(own);
    used.insert(BlockPath());
  }
  else if (auto* like = vtkDataObjectTree::SafeDownCast(own))
  {
    auto tree = vtk::TakeSmartPointer(like->NewInstance());
    tree->CopyStructure(like);
    tree->GetFieldData()->PassData(like->GetFieldData());
    Fill(like, tree, BlockPath(), blocks, used);
    whole = tree;
  }
  else
  {
    return own; // such as AMR, which has no surfaces
  }
  for (const auto& [path, block] : blocks)
  {
    if (used.count(path) == 0)
    {
      throw InputError("the ranks have data of different structures: rank " +
        std::to_string(block.pieces.front().rank) + " has data" + block.pieces.front().name +
        ", and another rank has no such block. A surface that is divided between ranks has the "
        "same blocks on each, of which some may be empty");
    }
  }
  return whole;
}

template <typename Function>
void ForEachArray(vtkFieldData* arrays, const Function& f)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    f(arrays->GetAbstractArray(i));
  }
}

} // namespace

WholeSurface::WholeSurface(ControllerRanks& ranks, vtkDataObject* own, const IsWhole& isWhole)
{
  BlocksByPath blocks;
  for (Piece& piece : PiecesOfAllRanks(ranks, PiecesOf(own, {})))
  {
    WholeBlock& block = blocks[piece.path];
    block.pieces.push_back(std::move(piece));
  }
  for (auto& [path, block] : blocks)
  {
    PutTogether(block, isWhole);
  }
  this->Whole = Assembled(own, blocks);
  const auto note = [&](vtkAbstractArray* array) { this->Before.insert(array); };
  ForEachArray(this->Whole->GetFieldData(), note);
  for (auto& [path, block] : blocks)
  {
    if (auto* surface = vtkPolyData::SafeDownCast(block.data))
    {
      ForEachArray(surface->GetPointData(), note);
      ForEachArray(surface->GetCellData(), note);
      ForEachArray(surface->GetFieldData(), note);
    }
    this->Blocks.push_back(std::move(block));
  }
}

void WholeSurface::PutResults(vtkDataObject* own, std::size_t rank) const
{
  const PieceResults results(this->Before);
  const std::vector<Piece> outputs = PiecesOf(own, {}); // in the order in which they were sent
  for (const WholeBlock& block : this->Blocks)
  {
    auto output = outputs.begin();
    for (std::size_t piece = 0; piece < block.merged.pointOf.size(); ++piece)
    {
      if (block.pieces[piece].rank == rank)
      {
        output = std::find_if(output, outputs.end(),
          [&](const Piece& candidate) { return candidate.path == block.pieces[piece].path; });
        results.Put(block.merged, piece, vtkPolyData::SafeDownCast(output->data));
        ++output;
      }
    }
  }
  results.AddFields(this->Whole->GetFieldData(), own->GetFieldData());
}

} // namespace Illumination
