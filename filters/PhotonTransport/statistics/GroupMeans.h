// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace PhotonTransport
{

/// An illumination map as four independent estimates, each the mean over a quarter of the
/// replicates. Their differences tell how the noise of the map is correlated, which filtration
/// needs to know.
constexpr std::size_t Groups = 4;
using GroupValues = std::array<double, Groups>;

struct GroupMeans
{
  std::vector<GroupValues> direct;   ///< lx
  std::vector<GroupValues> indirect; ///< lx
};

} // namespace PhotonTransport
