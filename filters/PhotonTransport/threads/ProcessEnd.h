// SPDX-License-Identifier: BSD-3-Clause
// How Embree's and oneTBB's objects are owned, so that a process may end while they exist.
//
// A process that ends destroys its static objects library by library, those of the libraries that
// were loaded last (a plugin, Embree, oneTBB) first. Whoever owns a filter (ParaView's session,
// Python, a global smart pointer) may be destroyed after that. Embree's locks no longer exist then.
// Releasing a scene then either throws out of a destructor, which ends the process with status 134,
// or hangs. So nothing of Embree's or oneTBB's is released once destruction has begun; the
// operating system takes the memory back.
#pragma once

#include <memory>
#include <utility>

namespace PhotonTransport
{

/// Whether the destruction of static objects has reached this library; those of Embree and oneTBB
/// are destroyed next. Never goes back to false. May be called at any time, from any thread.
bool ProcessIsEnding();

/// To be called before the first object is made: from then on ProcessIsEnding() notices the end.
/// Throws std::runtime_error if the process is ending already.
void NoticeProcessEnd();

struct DeleteUnlessProcessEnds
{
  template <class T>
  void operator()(T* object) const
  {
    if (!ProcessIsEnding())
    {
      delete object;
    }
  }
};

/// Owns an object whose destructor calls Embree or oneTBB.
template <class T>
using ProcessPtr = std::unique_ptr<T, DeleteUnlessProcessEnds>;

template <class T, class... Arguments>
ProcessPtr<T> MakeProcessPtr(Arguments&&... arguments)
{
  NoticeProcessEnd();
  return ProcessPtr<T>(new T(std::forward<Arguments>(arguments)...));
}

} // namespace PhotonTransport
