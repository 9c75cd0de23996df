// SPDX-License-Identifier: BSD-3-Clause
// All that runs on several threads goes through this file. Threads.cxx is the one that knows
// oneTBB.
#pragma once

#include "PhotonTransport/threads/ProcessEnd.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// How many threads a setting means. @param setting 0: one for each core.
int ThreadCount(int setting);

/// So many threads, more than there are cores if need be.
class Threads
{
public:
  /// @param setting See ThreadCount. Throws std::runtime_error if the process is ending.
  explicit Threads(int setting);
  ~Threads();

  /// Calls work() on one of the threads; loops in it run on all of them. What it throws comes out.
  void Run(const std::function<void()>& work);

private:
  struct Arena;
  ProcessPtr<Arena> Own;
};

/// Calls body(begin, end) for ranges that cover [first, last) once, on the threads on which it is
/// called. The threads have the caller's floating-point settings. oneTBB's threads otherwise have
/// the settings under which oneTBB was first used in the process. Where Embree was the first to use
/// it, they flush small numbers to zero, and a result would depend on who came first.
/// @param grain Ranges are not divided further once they are as short as this; >= 1.
void ParallelFor(std::uint64_t first, std::uint64_t last,
  const std::function<void(std::uint64_t begin, std::uint64_t end)>& body, std::uint64_t grain = 1);

/// So many calls of something simple are not worth a thread.
constexpr std::uint64_t SimpleCalls = 1024;

/// Calls body(i) for i in [0, count), on many threads as ParallelFor does. @param grain See there.
template <typename Body>
void ForEach(std::size_t count, const Body& body, std::uint64_t grain = SimpleCalls)
{
  ParallelFor(
    0, count,
    [&](std::uint64_t begin, std::uint64_t end)
    {
      for (std::uint64_t i = begin; i < end; ++i)
      {
        body(i);
      }
    },
    grain);
}

/// The place of the calling thread among those of a loop, from 0. To be called in a loop's body.
std::size_t ThreadIndex();
/// Indices are less than this on the threads on which it is called.
std::size_t MostThreadIndices();

/// A value for each place that threads have in a loop, so that a loop needs no locks. There are
/// never more values than threads work at a time: oneTBB's enumerable_thread_specific has one for
/// each thread of the process that ever came by, which was 16 maps for runs on two threads.
template <typename T>
class PerThread
{
public:
  explicit PerThread(std::size_t threads, const T& value = {})
    : Values(threads, value)
  {
  }
  T& Own() { return this->Values[ThreadIndex()]; }
  auto begin() { return this->Values.begin(); }
  auto end() { return this->Values.end(); }

private:
  std::vector<T> Values;
};

} // namespace PhotonTransport
