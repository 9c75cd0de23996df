// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/registration/IlluminationSums.h"

#include "PhotonTransport/threads/Ranks.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

template <typename Part>
void MoveInto(std::vector<Part>& total, std::vector<Part>& part)
{
  const std::size_t both = std::min(total.size(), part.size());
  ForEach(both,
    [&](std::size_t i)
    {
      total[i] += part[i];
      part[i] = Part{};
    });
  std::fill(part.begin() + static_cast<std::ptrdiff_t>(both), part.end(), Part{});
}

} // namespace

PhotonBalance IlluminationSums::Balance() const
{
  PhotonBalance sum;
  for (const PhotonBalance& balance : this->balances)
  {
    sum += balance;
  }
  return sum;
}

void MoveInto(LightLayers& total, LightLayers& part)
{
  MoveInto(total.sums, part.sums);
  MoveInto(total.lampCells.all, part.lampCells.all);
  MoveInto(total.lampCells.caustic, part.lampCells.caustic);
}

void MoveInto(IlluminationSums& total, IlluminationSums& part)
{
  MoveInto(total.front, part.front);
  MoveInto(total.back, part.back);
  MoveInto(total.layers, part.layers);
  MoveCounts(total, part);
}

void MoveCounts(IlluminationSums& total, IlluminationSums& part)
{
  MoveInto(total.arrivals, part.arrivals);
  total.cells += part.cells;
  part.cells.Clear();
  MoveInto(total.cutByWeightBound, part.cutByWeightBound);
  MoveInto(total.balances, part.balances);
}

void SumOver(Ranks& ranks, IlluminationSums& sums)
{
  ranks.SumAll(sums.front);
  ranks.SumAll(sums.back);
  ranks.SumAll(sums.layers.sums);
  ranks.SumAll(sums.layers.lampCells.all);
  ranks.SumAll(sums.layers.lampCells.caustic);
  ranks.SumAll(sums.cells.all); // below 2^32 in all: see CellCounts::Full
  ranks.SumAll(sums.cells.caustic);
  ranks.SumAll(sums.arrivals);
  ranks.SumAll(sums.cutByWeightBound);
  ranks.SumAll(sums.balances);
}

} // namespace PhotonTransport
