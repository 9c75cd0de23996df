// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_group.h>

#include <cstdint>

namespace PhotonTransport
{

/// tbb::parallel_for over [first, last) whose threads have the caller's floating-point settings.
/// oneTBB's threads otherwise have the settings under which oneTBB was first used in the process.
/// Where Embree was the first to use it, they flush small numbers to zero, and a result would
/// depend on who came first.
template <class Body>
void ParallelFor(std::uint64_t first, std::uint64_t last, const Body& body)
{
  tbb::task_group_context context(tbb::task_group_context::bound,
    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  tbb::parallel_for(tbb::blocked_range<std::uint64_t>(first, last), body, context);
}

} // namespace PhotonTransport
