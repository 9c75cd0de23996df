// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/PolygonTriangles.h"

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// A flat convex polygon that covers triangles, seen along the mean of their normals.
struct ConvexCover
{
  std::vector<TriangleCorners> triangles; ///< Counter-clockwise about the normal.
  glm::dvec3 normal{ 0.0 };               ///< Unit; the mean by area.
  double above = 0.0; ///< How far the covered triangles reach beyond it, along the normal.
  double below = 0.0; ///< The same against the normal.
};

/// The convex hull of the triangles' projection (A. Andrew, "Another Efficient Algorithm for Convex
/// Hulls in Two Dimensions", 1979), through the mean of their corners.
/// @param triangles One or more, whose normals do not cancel.
ConvexCover CoverOf(const std::vector<TriangleCorners>& triangles);

} // namespace PhotonTransport
