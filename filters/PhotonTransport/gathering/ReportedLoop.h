// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/threads/Threads.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

namespace PhotonTransport
{

/// Called now and then from one thread with how many calls are done; returns false to stop.
using LoopReport = std::function<bool(std::uint64_t done)>;

/// Calls work(i) for i in [0, number) on the threads on which it is called, as ParallelFor does.
/// @param makeWork Gives the function `work`, with what it needs for itself, for each range.
/// @param reporter The thread that reports. @return Whether all are done.
template <class MakeWork>
bool ReportedFor(std::uint64_t number, std::thread::id reporter, const LoopReport& report,
  const MakeWork& makeWork)
{
  std::atomic<std::uint64_t> done{ 0 };
  std::atomic<bool> goOn{ true };
  const auto range = [&](std::uint64_t begin, std::uint64_t end)
  {
    auto work = makeWork();
    for (std::uint64_t i = begin; i < end && goOn; ++i)
    {
      work(i);
      const std::uint64_t all = ++done;
      constexpr std::uint64_t Often = 64;
      if (report && i % Often == 0 && std::this_thread::get_id() == reporter && !report(all))
      {
        goOn = false;
      }
    }
  };
  constexpr std::uint64_t Grain = 4;
  ParallelFor(0, number, range, Grain);
  return goOn;
}

} // namespace PhotonTransport
