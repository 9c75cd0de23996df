// SPDX-License-Identifier: BSD-3-Clause
#ifndef BackgroundRun_h
#define BackgroundRun_h

#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/StopRules.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace Illumination
{

/// Goes on with a run in a thread of its own, while its owner shows what the run has found before.
/// The owner asks now and then whether it is done. While nobody asks, the run pauses, so that it
/// leaves the cores to others.
class BackgroundRun
{
public:
  /// @param run Must outlive this.
  explicit BackgroundRun(PhotonTransport::IlluminationRun& run)
    : Run(run)
  {
  }
  ~BackgroundRun();
  BackgroundRun(const BackgroundRun&) = delete;
  BackgroundRun& operator=(const BackgroundRun&) = delete;

  /// Goes on until a rule ends the run. From now on nobody else may use the run until Stop has
  /// returned. @param rules Of one rank alone.
  void Start(PhotonTransport::StopRules rules);

  /// Stops the run after the slice that it is at, so that it can go on later, and waits for that.
  /// Throws what the run has thrown. Does nothing if the run was not started.
  void Stop();

  /// Whether a rule has ended the run since Start. False if it was not started.
  bool IsDone();

private:
  using Clock = std::chrono::steady_clock;

  /// Waits while nobody asks. @return Whether to stop.
  bool MustStop();
  void Join();

  PhotonTransport::IlluminationRun& Run;
  std::thread Thread;
  std::mutex Mutex; ///< Of all below.
  std::condition_variable Changed;
  Clock::time_point LastAsked;
  bool IsStopping = false;
  bool HasEnded = false;
  std::exception_ptr Thrown;
};

} // namespace Illumination

#endif
