// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LinkSolver.h"

#include "PhotonTransport/gathering/CellSides.h"
#include "PhotonTransport/threads/Threads.h"

#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Whether a sweep has changed next to nothing.
bool HasConverged(const std::vector<float>& before, const std::vector<float>& after)
{
  constexpr double Converged = 1e-4; // change of all light
  double change = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    change += std::fabs(double{ after[i] } - before[i]);
    all += after[i];
  }
  return change <= Converged * all;
}

} // namespace

LinkSolver::LinkSolver(const LinkTable& table, std::size_t replicates,
  const std::vector<const DiffuseShares*>& shares, const std::vector<std::uint32_t>& others)
  : Table(table)
  , Replicates(replicates)
  , Shares(shares)
  , Others(others)
{
}

std::vector<float> LinkSolver::Arriving() const
{
  constexpr int MostSweeps = 500;
  std::vector<float> arriving = this->Table.direct;
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    const std::vector<float> leaving = this->Leaving(arriving);
    std::vector<float> next = this->Table.direct;
    ForEach(this->Table.sides.size() * this->Replicates,
      [&](std::size_t row) { this->AddLinked(row, leaving, &next[row * this->Table.values]); });
    const bool done = HasConverged(arriving, next);
    arriving.swap(next);
    if (done)
    {
      break;
    }
  }
  return arriving;
}

/// @param row [side][replicate] @param sum [channel][lamp]
void LinkSolver::AddLinked(std::size_t row, const std::vector<float>& leaving, float* sum) const
{
  const LinkTable& table = this->Table;
  const std::size_t lamps = table.Lamps();
  for (std::uint64_t l = row == 0 ? 0 : table.ends[row - 1]; l < table.ends[row]; ++l)
  {
    const std::size_t linked = table.links[l] * this->Replicates + row % this->Replicates;
    const float* from = &leaving[linked * table.values];
    for (std::size_t i = 0; i < table.values; ++i)
    {
      sum[i] += table.weights[l * table.channels + i / lamps] * from[i];
    }
  }
}

std::vector<float> LinkSolver::Leaving(const std::vector<float>& arriving) const
{
  const std::size_t values = this->Table.values;
  const std::size_t perSide = this->Replicates * values;
  const std::size_t lamps = this->Table.Lamps();
  std::vector<float> leaving(arriving.size());
  ForEach(this->Table.sides.size(),
    [&](std::size_t k)
    {
      const DiffuseShares& shares = *this->Shares[k];
      const std::uint32_t other = this->Others[k];
      for (std::size_t i = 0; i < perSide; ++i)
      {
        const int c = static_cast<int>(i % values / lamps);
        const float through =
          other == NoSide ? 0.0f : shares.through[c] * arriving[other * perSide + i];
        leaving[k * perSide + i] = shares.reflected[c] * arriving[k * perSide + i] + through;
      }
    });
  return leaving;
}

} // namespace PhotonTransport
