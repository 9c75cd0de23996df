// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

#if defined(__x86_64__)
/// Flattened, so that all of the work is compiled for these processors.
template <typename Work>
[[gnu::target("avx2"), gnu::flatten]] void WorkByAvx2(const Work& work)
{
  work();
}
#endif

/// Calls work(), which is compiled twice: for the processors that the whole program is for, and for
/// those with vectors of eight numbers (AVX2). Both have the same bits, since no operation rounds
/// differently there.
template <typename Work>
void WithWideVectors(const Work& work)
{
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
  {
    WorkByAvx2(work);
    return;
  }
#endif
  work();
}

} // namespace PhotonTransport
