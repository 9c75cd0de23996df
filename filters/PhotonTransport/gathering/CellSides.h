// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/CellSide.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Which sides rays have met, from any thread.
class SidesMet
{
public:
  explicit SidesMet(std::size_t cells)
    : Met(cells * 2)
  {
  }
  void Add(std::size_t side) { this->Met[side].store(1, std::memory_order_relaxed); }

  /// Those for which `wanted` holds, rising.
  template <class Wanted>
  std::vector<std::uint32_t> List(const Wanted& wanted) const
  {
    std::vector<std::uint32_t> list;
    for (std::uint32_t side = 0; side < this->Met.size(); ++side)
    {
      if (this->Met[side].load(std::memory_order_relaxed) != 0 && wanted(side))
      {
        list.push_back(side);
      }
    }
    return list;
  }

private:
  std::vector<std::atomic<std::uint8_t>> Met;
};

} // namespace PhotonTransport
