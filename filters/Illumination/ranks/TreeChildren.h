// SPDX-License-Identifier: BSD-3-Clause
#ifndef TreeChildren_h
#define TreeChildren_h

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkSmartPointer.h"

namespace Illumination
{

/// Calls f(iterator, number) for each child of a composite data set, in their order, those that
/// are empty included.
template <typename Function>
void ForEachChild(vtkDataObjectTree* tree, const Function& f)
{
  auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
  it->TraverseSubTreeOff();
  it->VisitOnlyLeavesOff();
  it->SkipEmptyNodesOff();
  int number = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem(), ++number)
  {
    f(it.Get(), number);
  }
}

} // namespace Illumination

#endif
