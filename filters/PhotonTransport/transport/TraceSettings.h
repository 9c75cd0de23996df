// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/EffectSettings.h"
#include "PhotonTransport/sampling/Sampling.h"

#include <cstdint>

namespace PhotonTransport
{

struct Lighting;

/// More threads are refused: oneTBB ends the process if the system can't give it a thread.
constexpr int MostThreads = 1024;

/// How the map is made.
enum class Method : int
{
  PhotonTracing = 0, ///< Photons register at the vertices.
  FinalGathering =
    1 ///< A second pass gathers at the vertices what photons have lit; FinalGathering.
};

constexpr std::uint32_t LeastGatherRays = 16;
constexpr std::uint32_t MostGatherRays = 1u << 14;

/// How to trace, as opposed to what and for how long.
struct TraceSettings : EffectSettings
{
  Method method = Method::PhotonTracing;
  /// Rays for each vertex in Method::FinalGathering, [LeastGatherRays,
  /// MostGatherRays], about; 0: as many as suit the photons, see RaysFor.
  std::uint32_t gatherRays = 0;
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

/// Whether a run keeps what other fluxes of its lamps need for their map.
inline bool CanBeRelit(const TraceSettings& settings)
{
  return settings.lampsApart && settings.method == Method::PhotonTracing;
}

/// Whether all light of a lamp has the colour of its luminaire, wherever it arrives, and lamps are
/// kept apart, so that the map has colours without layers of them. @param colouredFacets Whether
/// any facet is coloured; see Effects.
bool LampsTellColours(const Lighting& lighting, const TraceSettings& settings, bool colouredFacets);

/// Throws InvalidInput that names the setting.
void Validate(const TraceSettings& settings);

} // namespace PhotonTransport
