// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// How far, as a part of the largest coordinate, three points of a line can come to lie off it when
/// their coordinates are rounded to nearest. The bound is 2 sqrt(3) = 3.5 units of 2^-24 in single
/// precision; in double precision, where no facet is that low, it leaves room for a rotation.
constexpr double SingleRounding = 0x1p-22;
constexpr double DoubleRounding = 0x1p-49;

/// Whether a triangle has an area, and with it a direction to face: its corners do not lie on a
/// line, even where rounding moved them off it. A triangle as low as that has one all the same if
/// it is not much longer than high: it is a small facet far from the origin.
/// @param rounding SingleRounding or DoubleRounding, as the coordinates were rounded.
bool HasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double rounding);

} // namespace PhotonTransport
