// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// Three points on a line come to lie off it when their coordinates are rounded to nearest. These
/// are bounds for how far, as a part of the largest coordinate. The exact bound is 2 sqrt(3) = 3.5
/// units of 2^-24 in single and of 2^-53 in double precision. In single precision this is 4 units.
/// In double precision it is 16 units, which leaves room for the rounding of a rotation; no real
/// facet is that low.
constexpr double SingleRounding = 0x1p-22;
constexpr double DoubleRounding = 0x1p-49;

/// Whether a triangle has an area, and with it a direction to face. It has none if its corners may
/// be three points of a line that rounding has moved off it. A triangle that is less than 64 times
/// as long as high has an area in any case: it is a small facet far from the origin.
/// @param rounding SingleRounding or DoubleRounding, as the coordinates were rounded.
bool HasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double rounding);

} // namespace PhotonTransport
