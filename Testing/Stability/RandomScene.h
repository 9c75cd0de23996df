// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <iosfwd>
#include <string>

/// A scene such as nobody would draw: any points, any facets, any materials, any lamps.
struct RandomScene
{
  PhotonTransport::Surface surface;
  PhotonTransport::Lighting lighting;
  PhotonTransport::TraceSettings settings;
  std::uint64_t photons = 0;
  /// The value that makes no sense and has to be refused; empty if there is none.
  std::string mistake;
};

/// All of it in words and numbers, for the report of a failure.
std::ostream& operator<<(std::ostream& out, const RandomScene& scene);

/// Draws a scene. To be called by rapidcheck: each choice is one of its own, so that a scene that
/// fails shrinks to the least that fails.
RandomScene DrawScene();

/// The same, with one value in it that makes no sense.
RandomScene DrawSceneWithMistake();
