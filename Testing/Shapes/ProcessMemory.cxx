// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessMemory.h"

#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

double ProcessMemory::Status(const std::string& key)
{
  std::ifstream in("/proc/self/status");
  std::string word;
  while (in >> word && word != key)
  {
  }
  double kibibytes = 0.0;
  in >> kibibytes;
  return 1024.0 * kibibytes;
}

void ProcessMemory::ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

void ProcessMemory::AllocateInOnePlace()
{
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, 1);
#endif
}

double ProcessMemory::Allocated()
{
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
#else
  return 0.0;
#endif
}

void ProcessMemory::GiveBack()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}
