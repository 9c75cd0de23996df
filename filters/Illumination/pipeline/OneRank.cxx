// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/pipeline/OneRank.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace Illumination
{
namespace
{

enum Holdings : int
{
  Surfaces = 1,
  Luminaires = 2
};

/// Whether `test` holds for the data or for any of its blocks.
template <class Test>
bool AnyBlock(vtkDataObject* data, const Test& test)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return test(data);
  }
  auto it = vtk::TakeSmartPointer(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (test(it->GetCurrentDataObject()))
    {
      return true;
    }
  }
  return false;
}

bool HasFacets(vtkDataObject* block)
{
  auto* surface = vtkPolyData::SafeDownCast(block);
  return surface &&
    surface->GetPolys()->GetNumberOfCells() + surface->GetStrips()->GetNumberOfCells() > 0;
}

bool HasPoints(vtkDataObject* block)
{
  auto* set = vtkDataSet::SafeDownCast(block);
  return set && set->GetNumberOfPoints() > 0;
}

int HoldingsOf(vtkDataObject* surfaces, vtkInformationVector* luminaires)
{
  int holdings = AnyBlock(surfaces, HasFacets) ? Surfaces : 0;
  for (int i = 0; luminaires && i < luminaires->GetNumberOfInformationObjects(); ++i)
  {
    if (AnyBlock(vtkDataObject::GetData(luminaires, i), HasPoints))
    {
      holdings |= Luminaires;
    }
  }
  return holdings;
}

/// "ranks 0, 2 of 3", those that hold something of the kind; empty if none does.
std::string RanksWith(const std::vector<int>& holdings, int kind)
{
  std::string ranks;
  int count = 0;
  for (std::size_t rank = 0; rank < holdings.size(); ++rank)
  {
    if ((holdings[rank] & kind) != 0)
    {
      ranks += (count++ == 0 ? "" : ", ") + std::to_string(rank);
    }
  }
  return ranks.empty()
    ? ranks
    : (count == 1 ? "rank " : "ranks ") + ranks + " of " + std::to_string(holdings.size());
}

std::string SpreadMessage(const std::vector<int>& holdings)
{
  const std::string luminaires = RanksWith(holdings, Luminaires);
  const std::string cure = luminaires.empty()
    ? "Run ParaView or pvserver on one rank, or put the filter Aggregate Dataset with 1 target "
      "process before this one."
    : "Run ParaView or pvserver on one rank.";
  return "the scene is spread over several MPI ranks: surfaces are on " +
    RanksWith(holdings, Surfaces) + (luminaires.empty() ? "" : ", luminaires on " + luminaires) +
    ". Each rank sees only its own part, so light and shadows of the others would be missing; "
    "there is no result. " +
    cure;
}

} // namespace

RankTask TaskOfThisRank(vtkDataObject* surfaces, vtkInformationVector* luminaires)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return {};
  }
  const int own = HoldingsOf(surfaces, luminaires);
  std::vector<int> all(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(&own, all.data(), 1);
  const auto holders = all.size() - static_cast<std::size_t>(std::count(all.begin(), all.end(), 0));
  const bool first = controller->GetLocalProcessId() == 0;
  // Luminaires alone are no scene: the rank that works reports that there are no surfaces.
  if (holders > 1 && !RanksWith(all, Surfaces).empty())
  {
    return { false, first ? SpreadMessage(all) : "" };
  }
  return { holders == 1 ? own != 0 : first, "" };
}

} // namespace Illumination
