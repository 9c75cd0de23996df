// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Shapes.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <string>
#include <vector>

/// A scene that calls for an effect, and the scene that differs only in not calling for it.
struct EffectScene
{
  std::string name;
  std::string reference; ///< Another scene's name.
  Shapes::Surface surface;
  PhotonTransport::Lighting lighting;
  PhotonTransport::TraceSettings settings;
};

/// The room with a sphere in it, about `triangles` triangles, with one effect after the other.
std::vector<EffectScene> EffectScenes(int triangles);
