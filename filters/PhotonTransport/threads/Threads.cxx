// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/threads/Threads.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <memory>

namespace PhotonTransport
{

int ThreadCount(int setting)
{
  return setting > 0 ? setting : tbb::info::default_concurrency();
}

struct Threads::Arena
{
  explicit Arena(int threads)
    : limit(MoreThanCores(threads))
    , arena(threads)
  {
  }

  /// oneTBB by itself never runs more threads than there are cores.
  static std::unique_ptr<tbb::global_control> MoreThanCores(int threads)
  {
    constexpr auto Limit = tbb::global_control::max_allowed_parallelism;
    const auto wanted = static_cast<std::size_t>(threads);
    return wanted > tbb::global_control::active_value(Limit)
      ? std::make_unique<tbb::global_control>(Limit, wanted)
      : nullptr;
  }

  std::unique_ptr<tbb::global_control> limit;
  tbb::task_arena arena;
};

Threads::Threads(int setting)
  : Own(MakeProcessPtr<Arena>(ThreadCount(setting)))
{
}

Threads::~Threads() = default;

void Threads::Run(const std::function<void()>& work)
{
  this->Own->arena.execute(work);
}

void ParallelFor(std::uint64_t first, std::uint64_t last,
  const std::function<void(std::uint64_t begin, std::uint64_t end)>& body, std::uint64_t grain)
{
  tbb::task_group_context context(tbb::task_group_context::bound,
    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  tbb::parallel_for(
    tbb::blocked_range<std::uint64_t>(first, last, grain),
    [&](const tbb::blocked_range<std::uint64_t>& range) { body(range.begin(), range.end()); },
    context);
}

std::size_t ThreadIndex()
{
  return static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
}

std::size_t MostThreadIndices()
{
  return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

} // namespace PhotonTransport
