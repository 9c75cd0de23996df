// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <glm/vec3.hpp>

#include <string>

namespace PhotonTransport
{

// What a lamp's description must hold to, in the scene's terms. Each throws InvalidInput that names
// what is wrong and its value.

[[noreturn]] void RefuseLamp(const std::string& message);

std::string Text(double value);

/// Finite and >= 0.
double CheckedAmount(double amount, const char* what);

/// In scene units; finite, >= 0, and not so long that Embree would end the process.
double CheckedLength(double length, const Scene& scene, const char* what);

/// In scene coordinates; finite, and not so far that Embree would end the process.
glm::dvec3 CheckedPosition(const glm::dvec3& position, const Scene& scene);

/// Unit length; the direction itself may have any but 0.
glm::dvec3 CheckedDirection(const glm::dvec3& direction, const char* what = "lamp direction");

} // namespace PhotonTransport
