// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/BackgroundRun.h"

#include <utility>

namespace Illumination
{
namespace
{

/// A window asks ten times a second, unless it is paused or the user turns the scene.
constexpr std::chrono::seconds Patience{ 1 };

} // namespace

BackgroundRun::~BackgroundRun()
{
  this->Join();
}

void BackgroundRun::Start(PhotonTransport::StopRules rules)
{
  this->LastAsked = Clock::now();
  this->IsStopping = this->HasEnded = false;
  rules.stopSoon = [this] { return this->MustStop(); };
  this->Thread = std::thread(
    [this, rules = std::move(rules)]
    {
      std::exception_ptr thrown;
      try
      {
        this->Run.Advance(rules);
      }
      catch (...)
      {
        thrown = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Thrown = thrown;
      this->HasEnded = true;
    });
}

void BackgroundRun::Stop()
{
  this->Join();
  if (const std::exception_ptr thrown = std::exchange(this->Thrown, nullptr))
  {
    std::rethrow_exception(thrown);
  }
}

bool BackgroundRun::IsDone()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->LastAsked = Clock::now();
  this->Changed.notify_all();
  return this->Thread.joinable() && this->HasEnded;
}

bool BackgroundRun::MustStop()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(
    lock, [this] { return this->IsStopping || Clock::now() - this->LastAsked < Patience; });
  return this->IsStopping;
}

void BackgroundRun::Join()
{
  if (this->Thread.joinable())
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsStopping = true;
      this->Changed.notify_all();
    }
    this->Thread.join();
  }
}

} // namespace Illumination
