// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/CellCopies.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace Illumination
{

std::vector<vtkIdType> FirstOfCopies(vtkCellArray* cells)
{
  const auto number = static_cast<std::size_t>(cells->GetNumberOfCells());
  std::vector<vtkIdType> corners; // of all cells, each from its least one
  std::vector<std::ptrdiff_t> begin = { 0 };
  corners.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  begin.reserve(number + 1);
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    std::rotate_copy(
      ids, std::min_element(ids, ids + size), ids + size, std::back_inserter(corners));
    begin.push_back(static_cast<std::ptrdiff_t>(corners.size()));
  }
  const auto range = [&](vtkIdType cell)
  {
    const auto c = static_cast<std::size_t>(cell);
    return std::pair(corners.begin() + begin[c], corners.begin() + begin[c + 1]);
  };
  const auto precedes = [&](vtkIdType a, vtkIdType b)
  {
    const auto [ofA, endA] = range(a);
    const auto [ofB, endB] = range(b);
    return std::lexicographical_compare(ofA, endA, ofB, endB);
  };
  std::vector<vtkIdType> order(number);
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  std::stable_sort(order.begin(), order.end(), precedes);
  std::vector<vtkIdType> first(number);
  for (std::size_t i = 0; i < number; ++i)
  {
    const bool isCopy = i > 0 && !precedes(order[i - 1], order[i]);
    first[static_cast<std::size_t>(order[i])] =
      isCopy ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

void StartCopiesAlike(vtkCellArray* cells)
{
  const std::vector<vtkIdType> first = FirstOfCopies(cells);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    const vtkIdType original = first[static_cast<std::size_t>(c)];
    if (original != c)
    {
      cells->GetCellAtId(original, corners);
      cells->ReplaceCellAtId(c, corners);
    }
  }
}

} // namespace Illumination
