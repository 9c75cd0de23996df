// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/Registration.h"
#include "PhotonTransport/sampling/PhotonSample.h"

#include <cstdint>

namespace PhotonTransport
{

/// oneTBB ends the process where the system has no thread left to give; this many it has.
constexpr int MostThreads = 1024;

/// How to trace, as opposed to what and for how long.
struct TraceSettings
{
  std::uint32_t replicates = 8; ///< Independent runs for the standard error; >= 2.
  std::uint32_t seed = 1;
  Sampling sampling = Sampling::Sobol;
  Registration registration = Registration::VertexNormalised;
  bool interreflection = true;   ///< false ends every photon at its first hit.
  bool registerBackSide = false; ///< Also register hits on the backs of facets.
  float weightBound = 16.0f;     ///< Largest compensating factor, [1, 2^20]; the rest is reported.
  std::uint32_t maximumPathLength = 10'000; ///< Segments of one photon; >= 1.
  int threads = 0;                          ///< [0, MostThreads]; 0: all there are.
};

/// Throws InvalidInput that names the setting.
void Validate(const TraceSettings& settings);

} // namespace PhotonTransport
