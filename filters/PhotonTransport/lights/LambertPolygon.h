// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace PhotonTransport
{

/// Configuration factor from a point to a flat convex polygon of four corners, or of three if two
/// in a row are the same: its share in what a surface at the point would receive if all of the
/// hemisphere were as bright. Lambert's formula, for the part above the horizon (Howell, "A Catalog
/// of Radiation Heat Transfer Configuration Factors", introduction to the contour integral).
/// @param corners From the point, in turn. @param normal Unit, of the surface at the point.
double ConfigurationFactor(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& normal);

} // namespace PhotonTransport
