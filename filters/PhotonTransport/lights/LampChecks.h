// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <string>

namespace PhotonTransport
{

// Checks of the numbers that describe a lamp. Each throws InvalidInput that names what is wrong and
// its value, and otherwise returns the value in the scene's terms.

/// Rounding of scene coordinates, with room to spare.
constexpr double FloatSlack = 1e-6;

[[noreturn]] void RefuseLamp(const std::string& message);

std::string Text(double value);

/// Finite and >= 0.
double CheckedAmount(double amount, const char* what);

inline double CheckedFlux(double flux)
{
  return CheckedAmount(flux, "luminous flux");
}

/// In scene units; finite, >= 0, and not so long that Embree would end the process.
double CheckedLength(double length, const Scene& scene, const char* what);

/// In scene coordinates; finite, and not so far that Embree would end the process.
glm::dvec3 CheckedPosition(const glm::dvec3& position, const Scene& scene);

/// The same, moved clear of facets. @param aim Unit, or zero for a lamp that has none.
glm::dvec3 ClearPosition(
  const glm::dvec3& position, const Scene& scene, const glm::dvec3& aim = glm::dvec3(0.0));

/// Unit length; the direction itself may have any but 0.
glm::dvec3 CheckedDirection(const glm::dvec3& direction, const char* what = "lamp direction");

} // namespace PhotonTransport
