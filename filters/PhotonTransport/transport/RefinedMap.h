// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/RefinedMesh.h"
#include "PhotonTransport/registration/IlluminationMap.h"

#include <array>
#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// A map on a surface that was refined where its light varies, see IlluminationRun::Refine. One
/// value a point of the mesh.
struct RefinedMap
{
  RefinedMesh mesh; ///< Its origins are parts of the given facets.
  bool isCoarse;    ///< Whether more facets were wanted than were allowed.
  /// Of the largest mesh on the way; see AdaptiveGathering::MostFacets.
  std::size_t mostFacets;

  IlluminationMap front;
  IlluminationMap back;                             ///< Empty unless the back is registered.
  std::vector<std::array<double, 3>> frontByColour; ///< See IlluminationRun::FrontByColour.
  std::vector<std::vector<double>> frontOfLamps;    ///< [lamp] See IlluminationRun::FrontOfLamp.
};

} // namespace PhotonTransport
