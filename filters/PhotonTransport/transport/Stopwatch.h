// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace PhotonTransport
{

/// Adds the time of its life, s, to a total.
class Stopwatch
{
public:
  explicit Stopwatch(double& total)
    : Total(total)
  {
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { this->Total += this->Seconds(); }

  /// Since it was made.
  double Seconds() const
  {
    const auto passed = std::chrono::steady_clock::now() - this->Start;
    return std::chrono::duration<double>(passed).count();
  }

private:
  double& Total;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

} // namespace PhotonTransport
