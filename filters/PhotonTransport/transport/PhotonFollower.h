// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/registration/PhotonHit.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/PhotonTracer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

class HitCollector;

/// Follows photons of a run once more and keeps their hits. Photons are functions of their index,
/// so a run need not keep anything: what is asked for is found again, with the same bits, and a run
/// that keeps no hits does no work for them.
///
/// The photons that are followed are the first ones: blocks in turn from each replicate. They are
/// an unbiased sample of all, whatever the run has traced beyond them, and spread as evenly as
/// Sobol points do. Photons chosen by a hash of their index would be a sample of random numbers.
class PhotonFollower
{
public:
  /// @param tracer Of the run, as `scene` is; must outlive this.
  PhotonFollower(const Scene& scene, const PhotonTracer& tracer, const TraceSettings& settings);

  /// The hits of the first photons, as many photons as have at most `most` hits together. The
  /// result is the same for any number of threads. @param blocks [replicate] How many blocks there
  /// are.
  /// @param goOn Called with the number of hits so far; where it returns false, these are the
  /// result.
  StoredPhotons Hits(const std::vector<std::uint64_t>& blocks, std::uint64_t most,
    const std::function<bool(std::uint64_t hits)>& goOn) const;

  /// The paths of the first photons of the first replicate that fly anywhere: not of those whose
  /// light comes by other photons, see OpeningPhotons. @param blocks How many there are.
  std::vector<PhotonPath> Paths(std::uint64_t photons, std::uint64_t blocks) const;

private:
  SequenceKey Key(std::uint32_t replicate) const;
  /// Of a photon of the first replicate.
  Ray StartOf(std::uint64_t photon) const;
  void Follow(std::uint32_t replicate, std::uint64_t first, std::uint64_t last,
    HitCollector& collector) const;

  const Scene& LitScene;
  const Emitter& Source;
  const OpeningPhotons* Openings;
  TraceSettings Settings;
  ScatteringSet Simulated;
  FacetRoulettes Materials;
};

} // namespace PhotonTransport
