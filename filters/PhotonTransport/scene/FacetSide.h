// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace PhotonTransport
{

/// Sine of the angle between a normal and a facet's plane up to which the normal does not tell the
/// facet's front: 0.06 degrees.
constexpr double InPlane = 1e-3;

/// The normal at unit length, or zero for a normal that is zero or not finite.
glm::dvec3 UsableNormal(const glm::dvec3& normal);

/// What the normals at a facet's corners say of its front.
struct FacetSide
{
  bool turned;    ///< The front is the side round which the corners run clockwise.
  bool undecided; ///< The normals lie in the facet's plane or cancel: the winding tells the front.
};

/// @param areaVector Points to the side round which the corners run counter-clockwise; not zero.
/// @param normals Of any length. Normals of which UsableNormal makes zero do not count. If none
/// counts, the facet is neither turned nor undecided.
FacetSide SideOf(const glm::dvec3& areaVector, const std::array<glm::dvec3, 3>& normals);

/// The same of normals that UsableNormal has made.
FacetSide SideByUsableNormals(
  const glm::dvec3& areaVector, const std::array<glm::dvec3, 3>& normals);

} // namespace PhotonTransport
