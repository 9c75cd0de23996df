// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/DiffuseShares.h"
#include "PhotonTransport/gathering/LinkTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Finds the light of all sides of a table from that of the sides to which they are linked: the
/// radiosity equation E = D + sum over the links of weight (rho_d E + tau_d E on the other side),
/// where D is the direct light (Cohen and Wallace, "Radiosity and Realistic Image Synthesis", 1993,
/// chapter 5).
class LinkSolver
{
public:
  /// All must outlive it. @param tables Together the table of all sides. @param shares [side of the
  /// table] @param others [side of the table] The place in the table of the other side of the same
  /// cell, or NoSide.
  LinkSolver(const std::vector<LinkTable>& tables, std::size_t replicates,
    const std::vector<const DiffuseShares*>& shares, const std::vector<std::uint32_t>& others);

  /// [side][replicate][channel][lamp] What arrives at sides. Solved by Jacobi's method, whose sums
  /// do not depend on the order of threads. It converges since every material absorbs, or light
  /// escapes.
  std::vector<float> Arriving() const;
  /// What leaves sides diffusely, from what arrives there; the same order.
  std::vector<float> Leaving(const std::vector<float>& arriving) const;

  /// Bytes of the lists of a side while Arriving is at work.
  static std::uint64_t BytesPerSide(std::size_t replicates, std::size_t values)
  {
    constexpr std::size_t Lists = 3; // what arrives, before and after a sweep, and leaves
    return Lists * replicates * values * sizeof(float);
  }

private:
  std::vector<float> Direct() const;
  void AddLinked(
    const LinkTable& table, std::size_t row, const std::vector<float>& leaving, float* sum) const;

  const std::vector<LinkTable>& Tables;
  std::size_t Values, Lamps;
  std::size_t Replicates;
  const std::vector<const DiffuseShares*>& Shares;
  const std::vector<std::uint32_t>& Others;
};

} // namespace PhotonTransport
