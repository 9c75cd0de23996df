// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/ChosenBlocks.h"

#include "Illumination/pipeline/InputError.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

namespace Illumination
{
namespace
{

vtkSmartPointer<vtkDataObjectTreeIterator> AllNodes(vtkDataObjectTree* tree)
{
  auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
  it->VisitOnlyLeavesOff();
  it->SkipEmptyNodesOff();
  it->InitTraversal();
  return it;
}

int CountNodes(vtkDataObjectTree* tree)
{
  int count = 0;
  for (auto it = AllNodes(tree); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    ++count;
  }
  return count;
}

void RequireThatAllExist(const std::set<int>& chosen, int last)
{
  for (const int block : chosen)
  {
    if (block < 0 || block > last)
    {
      throw InputError("there is no block " + std::to_string(block) +
        "; the flat indices of the input's blocks are 0 to " + std::to_string(last));
    }
  }
}

std::vector<ChosenBlock> BlocksOf(vtkDataObjectTree* tree, const std::set<int>& chosen)
{
  const int last = CountNodes(tree);
  RequireThatAllExist(chosen, last);
  std::vector<ChosenBlock> blocks;
  int chosenUntil = chosen.empty() || chosen.count(0) ? last : 0;
  for (auto it = AllNodes(tree); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    const int index = static_cast<int>(it->GetCurrentFlatIndex());
    vtkDataObject* node = it->GetCurrentDataObject();
    auto* branch = vtkDataObjectTree::SafeDownCast(node);
    if (chosen.count(index))
    {
      chosenUntil = std::max(chosenUntil, index + (branch ? CountNodes(branch) : 0));
    }
    if (auto* data = vtkPolyData::SafeDownCast(node))
    {
      blocks.push_back({ { data, " of block " + std::to_string(index) }, index <= chosenUntil });
    }
  }
  return blocks;
}

} // namespace

std::vector<ChosenBlock> ChooseBlocks(vtkDataObject* data, const std::set<int>& chosen)
{
  std::vector<ChosenBlock> blocks;
  if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    blocks.push_back({ { single, "" }, true });
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    blocks = BlocksOf(tree, chosen);
  }
  if (std::none_of(
        blocks.begin(), blocks.end(), [](const ChosenBlock& block) { return block.chosen; }))
  {
    throw InputError(chosen.empty() ? "the input has no surface (vtkPolyData)"
                                    : "none of the chosen blocks is a surface (vtkPolyData)");
  }
  return blocks;
}

} // namespace Illumination
