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

LinkSolver::LinkSolver(const std::vector<LinkTable>& tables, std::size_t replicates,
  const std::vector<const DiffuseShares*>& shares, const std::vector<std::uint32_t>& others)
  : Tables(tables)
  , Values(tables.empty() ? 1 : tables.front().values)
  , Lamps(tables.empty() ? 1 : tables.front().Lamps())
  , Replicates(replicates)
  , Shares(shares)
  , Others(others)
{
}

std::vector<float> LinkSolver::Direct() const
{
  std::vector<float> direct;
  direct.reserve(this->Shares.size() * this->Replicates * this->Values);
  for (const LinkTable& table : this->Tables)
  {
    direct.insert(direct.end(), table.direct.begin(), table.direct.end());
  }
  return direct;
}

std::vector<float> LinkSolver::Arriving() const
{
  constexpr int MostSweeps = 500;
  std::vector<float> arriving = this->Direct();
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    const std::vector<float> leaving = this->Leaving(arriving);
    std::vector<float> next = this->Direct();
    float* first = next.data();
    for (const LinkTable& table : this->Tables)
    {
      ForEach(table.ends.size(),
        [&](std::size_t row) { this->AddLinked(table, row, leaving, first + row * this->Values); });
      first += table.direct.size();
    }
    const bool done = HasConverged(arriving, next);
    arriving.swap(next);
    if (done)
    {
      break;
    }
  }
  return arriving;
}

/// @param row Of the table, [side][replicate]. @param sum [channel][lamp]
void LinkSolver::AddLinked(
  const LinkTable& table, std::size_t row, const std::vector<float>& leaving, float* sum) const
{
  for (std::size_t l = row == 0 ? 0 : table.ends[row - 1]; l < table.ends[row]; ++l)
  {
    const std::size_t linked = table.links[l] * this->Replicates + row % this->Replicates;
    const float* from = &leaving[linked * this->Values];
    for (std::size_t i = 0; i < this->Values; ++i)
    {
      sum[i] += table.weights[l * table.channels + i / this->Lamps] * from[i];
    }
  }
}

std::vector<float> LinkSolver::Leaving(const std::vector<float>& arriving) const
{
  const std::size_t perSide = this->Replicates * this->Values;
  std::vector<float> leaving(arriving.size());
  ForEach(this->Shares.size(),
    [&](std::size_t k)
    {
      const DiffuseShares& shares = *this->Shares[k];
      const std::uint32_t other = this->Others[k];
      for (std::size_t i = 0; i < perSide; ++i)
      {
        const int c = static_cast<int>(i % this->Values / this->Lamps);
        const float through =
          other == NoSide ? 0.0f : shares.through[c] * arriving[other * perSide + i];
        leaving[k * perSide + i] = shares.reflected[c] * arriving[k * perSide + i] + through;
      }
    });
  return leaving;
}

} // namespace PhotonTransport
