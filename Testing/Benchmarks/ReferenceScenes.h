// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointReference.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"

#include <cstdint>
#include <string>
#include <vector>

/// A scene in which maps are compared with the light at single points.
struct ReferenceScene
{
  PhotonTransport::Surface surface;
  PhotonTransport::Lighting lighting;
  std::vector<Guide> guides;         ///< Where light comes from, for the reference alone.
  std::vector<std::uint32_t> points; ///< Vertices to compare at.
  /// Of `points` only the first so many with more than 1 lx; 0: all, dark ones too.
  std::size_t lit = 0;
  double target = 0.01; ///< Relative standard error of the reference at each point.
};

/// room: a closed room of 4 x 4 x 3 m under a panel, with a sphere of 10 242 vertices, which count.
/// daylight: a room with a window, ground before it, and an overcast sky; floor and walls count.
/// cube10, cube20, cube40: a closed cube with a lamp at its centre; an eighth of a face counts.
/// cie171: the same of reflectance 0.5, with 10 000 lm, the case 5.8 of CIE 171.
/// cabin: the example's cabin, of a file that cabin_mesh.py writes.
std::vector<std::string> ReferenceSceneNames();

/// Throws std::runtime_error for another name, or without the cabin's file.
/// @param folder Where the cabin's file is.
ReferenceScene MakeReferenceScene(const std::string& name, const std::string& folder);
