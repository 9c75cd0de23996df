// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// Makes elements without a value, if their type needs none.
template <typename T>
struct WithoutValue : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = WithoutValue<U>;
  };

  WithoutValue() = default;
  template <typename U>
  WithoutValue(const WithoutValue<U>&) noexcept
  {
  }

  template <typename U>
  void construct(U* place) noexcept
  {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// An array that a loop fills after resize(), which leaves its elements without a value: so the
/// threads of the loop are the first to touch its memory, each its own part, and it is written
/// once.
template <typename T>
using LargeArray = std::vector<T, WithoutValue<T>>;

} // namespace PhotonTransport
