// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/EffectSettings.h"
#include "PhotonTransport/sampling/Sampling.h"

#include <cstdint>

namespace PhotonTransport
{

/// More threads are refused: oneTBB ends the process if the system can't give it a thread.
constexpr int MostThreads = 1024;

/// How to trace, as opposed to what and for how long.
struct TraceSettings : EffectSettings
{
  std::uint32_t replicates = 8; ///< Independent sequences, for the standard error; >= 2.
  std::uint32_t seed = 1;
  Sampling sampling = Sampling::Sobol;
  bool lampsApart = false;   ///< Also keep each lamp's own map.
  float weightBound = 16.0f; ///< Largest compensating factor, [1, 2^20]; the rest is reported.
  std::uint32_t maximumPathLength = 10'000; ///< Segments of one photon; >= 1.
  int threads = 0;                          ///< [0, MostThreads]; 0: one for each core.
  /// Trace by the walk that has every effect in it, called for or not. The result has the same bits
  /// and takes longer. For tests.
  bool mostGeneralWalk = false;
};

/// Throws InvalidInput that names the setting.
void Validate(const TraceSettings& settings);

} // namespace PhotonTransport
