// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace PhotonTransport
{

/// Moves memory that is used at random onto huge pages, as far as it fills them: the processor
/// knows the places of a few thousand pages at a time, and looks up all others in memory. For
/// arrays that live long, since moving costs a copy. Does nothing where the system can't. Linux 6.1
/// or newer moves at once, older ones in time.
void UseHugePages(const void* memory, std::size_t bytes);

template <typename Array>
void UseHugePages(const Array& array)
{
  UseHugePages(array.data(), array.size() * sizeof(*array.data()));
}

/// Asks for huge pages before memory is first used, which costs no copy. Where the system has none
/// left, pages are small.
void ExpectHugePages(const void* memory, std::size_t bytes);

/// Gives an empty array its final size, on huge pages as far as the system has some.
template <typename Array>
void ResizeOnHugePages(Array& array, std::size_t size)
{
  array.reserve(size);
  ExpectHugePages(array.data(), size * sizeof(*array.data()));
  array.resize(size);
}

} // namespace PhotonTransport
