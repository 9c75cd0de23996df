// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/memory/HugePages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace PhotonTransport
{

#ifdef __linux__

void UseHugePages(const void* memory, std::size_t bytes)
{
  constexpr std::uintptr_t Page = std::uintptr_t{ 1 } << 21;
  constexpr int Collapse = 25; // MADV_COLLAPSE, which headers older than Linux 6.1 do not have
  const auto first = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (first + Page - 1) / Page * Page;
  const std::uintptr_t end = (first + bytes) / Page * Page;
  if (begin < end)
  {
    void* pages = reinterpret_cast<void*>(begin);
    // Advice: whether it is taken, and errors, change nothing but the time that access takes.
    if (madvise(pages, end - begin, MADV_HUGEPAGE) == 0)
    {
      madvise(pages, end - begin, Collapse);
    }
  }
}

#else

void UseHugePages(const void*, std::size_t) {}

#endif

} // namespace PhotonTransport
