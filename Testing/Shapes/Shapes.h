// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Surface.h"

#include <glm/vec3.hpp>

/// Surfaces whose illumination is known, for tests and benchmarks. Reflectance is 0 unless set.
namespace Shapes
{

using PhotonTransport::Surface;

/// Which way the point normals (and so the fronts) look.
enum class Facing
{
  Outward,
  Inward
};

/// Unit sphere from an octahedron, each facet split in four `levels` times: 4^(levels + 1) + 2
/// vertices.
Surface Octasphere(int levels, Facing facing);

/// Unit sphere from an icosahedron: 10 * 4^levels + 2 vertices.
Surface Icosphere(int levels, Facing facing);

/// Unit sphere of `around` x `along` patches with poles at +-z.
Surface UvSphere(int around, int along, Facing facing);

/// Torus about z, radii 1 and 0.4.
Surface Torus(int around, int across, Facing facing);

/// Open tube about z, radius 1, height 2, one patch an angle and `along` high.
Surface Tube(int around, int along, Facing facing);

/// Part of the unit sphere within `degrees` of +z, with a rim.
Surface Cap(int around, int along, double degrees);

/// Axis-parallel box with cells x cells squares a side; every side has its own vertices, so that
/// all rings are flat.
Surface Box(const glm::dvec3& low, const glm::dvec3& high, int cells, Facing facing);

/// Rectangle corner + u, v with cells x cells squares and normal u x v.
Surface Rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int cells);

/// Disk of radius `radius` about the z axis at height z, normal +z (or -z), `around` x `along`.
Surface Disk(double radius, double z, int around, int along, bool up);

/// Closed prism of length 1 along z over a triangle with one angle of `degrees`: an acute corner.
Surface Wedge(double degrees, Facing facing);

/// Edges of a rectangular opening: least, then largest coordinates.
struct Edges
{
  double u0, v0, u1, v1;
};

/// Room [-side/2, side/2]^2 x [0, height], seen from inside, with an opening in its roof (in x, y)
/// or in the wall y = side/2 (in x, z). The floor has cells x cells squares.
Surface OpenRoom(double side, double height, const Edges& opening, int cells);
Surface RoomWithWindow(double side, double height, const Edges& opening, int cells);

/// A closed room with a fine sphere inside, about `triangles` triangles; the benchmark's scene.
Surface RoomWithSphere(int triangles);

/// Both surfaces as one.
Surface Together(Surface a, const Surface& b);

Surface WithReflectance(Surface surface, float reflectance);
Surface WithExitance(Surface surface, float exitance);

} // namespace Shapes
