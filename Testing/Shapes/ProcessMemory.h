// SPDX-License-Identifier: BSD-3-Clause
// What this process takes of memory, where the system tells it in /proc.
#pragma once

#include <string>

namespace ProcessMemory
{

/// A line of /proc/self/status such as "VmRSS:", in bytes; 0 where there is none.
double Status(const std::string& key);
/// From now on "VmHWM:" is the peak since this call.
void ForgetPeak();
/// To be called before there are threads: from now on all of them allocate in one place, so that
/// Allocated() knows of it.
void AllocateInOnePlace();
/// Bytes that have been allocated and not freed; 0 where the library does not tell.
double Allocated();
/// Freed memory to the system, as far as the library can.
void GiveBack();

} // namespace ProcessMemory
