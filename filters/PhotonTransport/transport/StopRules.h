// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace PhotonTransport
{

/// When a run is over: the first rule reached wins.
struct StopRules
{
  /// Photons to stop at, [1, 1e10], rounded up: each replicate gets whole blocks of 256.
  std::uint64_t photons = 1'000'000;
  /// See MapErrors::relativeError: of the front, or of the back where only that is lit; of the
  /// region, if there is one (IlluminationRun::SetRegion). 0 is no target.
  double relativeError = 0.0;
  double seconds = 0.0; ///< Of tracing; 0 is no limit.
  /// Whether FacetError counts in the relative error. A run whose facets alone exceed the target
  /// ends (StopReason::FacetsTooLarge). Without effect in Method::FinalGathering.
  bool countFacetError = false;
  /// In Method::FinalGathering a run that has not gathered any light yet ends without a second pass
  /// where it would end with one for its number of photons: see IlluminationRun::IsPreliminary.
  bool preliminary = false;
  /// Asked between slices of the work on the thread that calls; true stops the run there, so that
  /// it can go on later (StopReason::Paused). Ranks that share a run must have none.
  std::function<bool()> stopSoon = nullptr;
};

/// A run towards a relative error ends when it has traced so many photons and none of them has
/// registered on any side. With 95 % confidence fewer than 3 of so many photons would register on
/// average, and no target can be met with so few. Without this rule the run would go on to
/// StopRules::photons.
constexpr std::uint64_t MostPhotonsInTheDark = 1u << 20;

/// Throws InvalidInput that names the rule.
void Validate(const StopRules& rules);

enum class StopReason : int
{
  PhotonLimit,
  RelativeError,
  TimeLimit,
  Abort,
  Paused,        ///< StopRules::stopSoon.
  SumsFull,      ///< Another round might overflow the sum of some vertex: ReplicateSums::AreFull.
  NothingLit,    ///< There is a target, and of MostPhotonsInTheDark none has registered.
  FacetsTooLarge ///< StopRules::countFacetError: no number of photons would meet the target.
};

} // namespace PhotonTransport
