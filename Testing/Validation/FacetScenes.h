// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

/// A scene in which facets are too large for the light somewhere.
struct FacetScene
{
  std::string name;
  PhotonTransport::Surface surface;
  PhotonTransport::Lighting lighting;
  std::uint64_t photons;
  std::uint32_t rays; ///< Of the second pass.
};

std::ostream& operator<<(std::ostream& os, const FacetScene& scene);

/// The error is at borders in closed cubes, around lamps, at hard and soft shadows and where boxes
/// stand on a floor, and there is none on a sphere in the sun.
std::vector<FacetScene> FacetScenes();
