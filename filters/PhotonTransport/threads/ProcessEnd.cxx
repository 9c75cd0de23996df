// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/threads/ProcessEnd.h"

#include <atomic>
#include <stdexcept>

namespace PhotonTransport
{
namespace
{

std::atomic<bool> Ending{ false }; // needs no destructor, so it can be read until the very end

struct Notice
{
  ~Notice() { Ending = true; }
};

} // namespace

bool ProcessIsEnding()
{
  return Ending;
}

void NoticeProcessEnd()
{
  if (Ending)
  {
    throw std::runtime_error("the process is ending: no scene can be built any more");
  }
  // Local, because it is then registered after the static objects of Embree and oneTBB, which exist
  // since they were loaded, and so it is destroyed before them.
  static const Notice notice;
}

} // namespace PhotonTransport
