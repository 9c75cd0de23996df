// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Shapes.h"

#include "PhotonTransport/lights/Lamp.h"

#include <string>
#include <vector>

/// What filtration is measured on.
struct FiltrationScene
{
  std::string name;
  std::string what;
  Shapes::Surface surface;
  PhotonTransport::Lamp lamp;
};

/// A: smooth light, a room and a sphere lit from a cove; B: the same with a sphere's hard shadow;
/// C: boxes in penumbrae on a floor that goes on below them; D: a mesh so coarse that smoothing
/// should do little; E: a torus above a wavy floor under a spot, never used while tuning.
std::vector<FiltrationScene> FiltrationScenes();
