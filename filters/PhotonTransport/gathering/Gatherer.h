// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/GatherWalk.h"
#include "PhotonTransport/gathering/Guide.h"
#include "PhotonTransport/gathering/ReceivedLight.h"
#include "PhotonTransport/openings/SeenOpenings.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How many rays gather light for a receiver: half of them find out where it comes from, the rest
/// go there.
struct GatherEffort
{
  /// @param rays In all, about; >= 1.
  explicit GatherEffort(std::uint32_t rays);
  /// Of a receiver, but for those to openings.
  std::size_t Rays() const { return this->probe * this->probe + this->guided * this->guided; }
  /// Strata along each side of a square with about so many of them; even, and 4 at least.
  static std::size_t StrataFor(double rays);
  /// The weight of the rays that probe. They and the guided ones are two unbiased estimates of the
  /// same light. Their weights do not depend on what was found, so that their sum is unbiased, too.
  double ShareOfProbe() const;
  /// Strata along each side of the square of directions; even.
  std::size_t probe;
  std::size_t guided;
  std::size_t opening;  ///< For directions to openings; each has its share of their number.
  unsigned lampSamples; ///< Of a lamp that has an extent.
};

/// Receives the light at one receiver after another.
class Gatherer
{
public:
  Gatherer(const GatherScene& scene, const CellExitance& exitance, const GatherEffort& effort)
    : Gathered(scene)
    , Exitance(exitance)
    , Effort(effort)
    , Walk(scene)
    , Reader(exitance)
  {
  }

  /// @param receiver Index, for its random numbers. @return The variance of the light by the rays
  /// and samples that were drawn, beside what the first pass errs by.
  double Receive(const Receiver& at, std::uint64_t receiver, ReceivedLight& light);

private:
  double AddLamps(const Receiver& at, std::uint64_t receiver, ReceivedLight& light);
  double Probe(const Receiver& at, std::uint64_t receiver, double share, ReceivedLight& light);
  double GatherGuided(
    const Receiver& at, std::uint64_t receiver, double share, ReceivedLight& light);
  double GatherThroughOpenings(const Receiver& at, std::uint64_t receiver, ReceivedLight& light);
  double GatherThrough(std::uint32_t opening, const SeenOpening& seen, std::size_t side,
    const Receiver& at, std::uint64_t receiver, ReceivedLight& light);
  void AddRay(const Receiver& at, const glm::vec3& direction, double factor);
  /// @param onwards See GatherWalk.
  void Follow(const LightThrough& through, const GatherSequence& sequence, ReceivedLight& light,
    NearGuide* onwards = nullptr);
  double VarianceOfRays(std::size_t side) const;

  GatherScene Gathered;
  const CellExitance& Exitance;
  GatherEffort Effort;
  GatherWalk<LightReader> Walk;
  LightReader Reader;
  Guide Directions;
  NearGuide Onwards;
  DirectResult OfLamps;
  std::vector<Ray> Rays;
  std::vector<LightThrough> Through; ///< [ray]
  std::vector<float> Factors;        ///< [ray] By how much its light counts.
};

} // namespace PhotonTransport
