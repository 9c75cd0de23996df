// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/memory/HugePages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace PhotonTransport
{

#ifdef __linux__

namespace
{

/// The part of some memory that fills huge pages.
struct WholePages
{
  WholePages(const void* memory, std::size_t bytes)
  {
    constexpr std::uintptr_t Page = std::uintptr_t{ 1 } << 21;
    const auto first = reinterpret_cast<std::uintptr_t>(memory);
    this->begin = (first + Page - 1) / Page * Page;
    this->end = (first + bytes) / Page * Page;
  }

  /// Whether advice is taken, and errors, change nothing but the time that access takes.
  bool Advise(int advice) const
  {
    return this->begin < this->end &&
      madvise(reinterpret_cast<void*>(this->begin), this->end - this->begin, advice) == 0;
  }

  std::uintptr_t begin, end;
};

} // namespace

void UseHugePages(const void* memory, std::size_t bytes)
{
  constexpr int Collapse = 25; // MADV_COLLAPSE, which headers older than Linux 6.1 do not have
  const WholePages pages(memory, bytes);
  if (pages.Advise(MADV_HUGEPAGE))
  {
    pages.Advise(Collapse);
  }
}

void ExpectHugePages(const void* memory, std::size_t bytes)
{
  WholePages(memory, bytes).Advise(MADV_HUGEPAGE);
}

#else

void UseHugePages(const void*, std::size_t) {}
void ExpectHugePages(const void*, std::size_t) {}

#endif

} // namespace PhotonTransport
