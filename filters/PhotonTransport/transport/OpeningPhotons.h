// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/registration/Arrivals.h"
#include "PhotonTransport/registration/PhotonBalance.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/Flight.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How photons outdoors may go.
struct OutdoorWays
{
  ScatteringSet switchedOn;        ///< Effects that are simulated.
  std::uint32_t maximumPathLength; ///< Segments.
  bool colouredFacets;             ///< Whether facets treat channels unequally.
  bool throughFacets;              ///< Whether the walk lets photons through facets.
};

/// What is done to photons on their way where light from afar comes through openings. A path of
/// light belongs to the first opening that it crosses inwards, so that it counts once: photons of
/// LightPart::Straight and Scattered start at openings if no other one has been crossed before, and
/// photons of the Whole that cross an opening end there.
class OpeningPhotons
{
public:
  /// The scene and the source must outlive it.
  OpeningPhotons(const Scene& scene, const Emitter& source, const OutdoorWays& ways);

  /// Photons [first, count) have just been emitted. Those that are to start at openings are traced
  /// back to where their light comes from, and those that have none end.
  /// @param balances, arrivals By source.
  /// @return How many photons there are now.
  std::size_t Start(Flight* photons, Ray* rays, std::size_t first, std::size_t count,
    PhotonBalance* balances, Arrivals* arrivals) const;

  /// Ends the photons that cross an opening inwards before their hits, if a part through openings
  /// has their light.
  /// @return How many photons are left.
  std::size_t HandOver(Flight* photons, Ray* rays, Hit* hits, std::size_t count,
    PhotonBalance* balances, Arrivals* arrivals) const;

private:
  /// A photon that is traced back.
  struct TracedBack
  {
    Flight photon;
    Ray start; ///< Out of the opening.
    Ray ray;   ///< As far as it has been traced.
    bool goesOn = true;
    bool starts = false;
  };
  void TraceBack(std::vector<TracedBack>& all) const;
  void Step(TracedBack& back, Hit hit) const;
  bool IsKept(const TracedBack& back) const;
  bool IsHandedOver(const Flight& photon, const Ray& ray, const Hit& hit) const;

  const Scene& LitScene;
  const Emitter& Source;
  OutdoorWays Ways;
  FacetRoulettes Materials;
};

} // namespace PhotonTransport
