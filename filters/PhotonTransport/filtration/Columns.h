// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace PhotonTransport
{

/// Leaves values unset that are made without a value. The first to write to them are then the loops
/// over all vertices, whose threads share the time that new memory takes.
template <typename Value>
struct UnsetAllocator : std::allocator<Value>
{
  template <typename Other>
  struct rebind
  {
    using other = UnsetAllocator<Other>;
  };

  UnsetAllocator() = default;
  template <typename Other>
  UnsetAllocator(const UnsetAllocator<Other>&)
  {
  }

  template <typename Made>
  void construct(Made* place)
  {
    ::new (static_cast<void*>(place)) Made;
  }
};

/// N values a vertex that are filtered side by side. Columns of a size alone are not set.
template <std::size_t N>
using Columns = std::vector<std::array<float, N>, UnsetAllocator<std::array<float, N>>>;

} // namespace PhotonTransport
