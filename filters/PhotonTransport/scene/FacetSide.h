// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace PhotonTransport
{

/// Sine of the angle to a facet's plane below which a normal does not tell its front: 0.06 degrees.
constexpr double InPlane = 1e-3;

/// The unit vector along it, or zero for a normal that says nothing: zero or not finite.
glm::dvec3 UsableNormal(const glm::dvec3& normal);

/// What the normals at a facet's corners say of its front.
struct FacetSide
{
  bool turned;    ///< It is the side round which the corners run clockwise.
  bool undecided; ///< They lie in the facet's plane or cancel; the winding tells it.
};

/// @param areaVector To the side round which the corners run counter-clockwise, not zero.
/// @param normals Of any length; those that are not usable do not count.
FacetSide SideOf(const glm::dvec3& areaVector, const std::array<glm::dvec3, 3>& normals);

} // namespace PhotonTransport
