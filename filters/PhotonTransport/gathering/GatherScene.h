// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/DirectLight.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstdint>

namespace PhotonTransport
{

/// Up to how many of its lengths away a cell may be near; see GatherWalk.
constexpr float NearCells = 2.0f;

/// What gathering rays are followed through. All must outlive it.
struct GatherScene
{
  const Scene& scene;
  const FacetCells& cells;
  const DirectLight& lamps;
  const FacetRoulettes& materials;
  const Openings& openings; ///< To the sky; or none.
  ScatteringSet switchedOn;
  std::uint32_t seed;
  std::uint32_t maximumPathLength; ///< Segments, >= 1.
};

} // namespace PhotonTransport
