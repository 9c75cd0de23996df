// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/ParallelFor.h"

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// Calls body(first, last) for ranges that cover [0, count), on the threads of the caller's arena.
template <typename Body>
void ForRanges(std::size_t count, const Body& body)
{
  constexpr std::size_t NotWorthAThread = 1024;
  if (count <= NotWorthAThread)
  {
    body(0, count);
    return;
  }
  ParallelFor(0, count,
    [&](const tbb::blocked_range<std::uint64_t>& range) { body(range.begin(), range.end()); });
}

/// Calls body(i) for i in [0, count).
template <typename Body>
void ForEach(std::size_t count, const Body& body)
{
  ForRanges(count,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        body(i);
      }
    });
}

} // namespace PhotonTransport
