// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <variant>

namespace PhotonTransport
{

// Lamps as the user describes them. Positions and sizes are in the data's length unit, directions
// point the way the light travels and may have any length but zero, fluxes are in lumens.

/// Light from infinitely far away, over the whole scene.
struct ParallelLight
{
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double illuminance = 1000.0; ///< lx on a plane perpendicular to the light.
};

/// The same intensity in all directions: I = flux / (4 pi).
struct PointLamp
{
  glm::dvec3 position{ 0.0 };
  double flux = 1000.0;
};

/// A small flat lamp: I = flux / pi * cos(theta) about the direction.
struct LambertianPointLamp
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double flux = 1000.0;
};

/// I = I_0 cos^n(theta) within the half-angle, nothing outside.
struct SpotLamp
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double halfAngle = 0.5; ///< Radians, (0, pi]; at most pi/2 with an exponent above 0.
  double exponent = 0.0;  ///< n >= 0; 0 is even light.
  double flux = 1000.0;
};

/// A Lambertian panel that shines to one side and stops no photons itself.
struct RectangleLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  /// Width runs along z x direction (along x for vertical light), height along direction x width.
  double width = 1.0;
  double height = 1.0;
  double flux = 1000.0;
};

/// As RectangleLamp, round.
struct DiskLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double radius = 1.0;
  double flux = 1000.0;
};

/// The surface's own facets shine from their fronts, each with its Surface::exitance.
struct EmittingFacets
{
};

/// Uniform luminance from every direction within 90 degrees of `up` (or from everywhere).
struct UniformSky
{
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
  double luminance = 1000.0; ///< cd/m^2; an unshaded facet that faces up receives pi times this.
  bool wholeSphere = false;
};

using Lamp = std::variant<ParallelLight, PointLamp, LambertianPointLamp, SpotLamp, RectangleLamp,
  DiskLamp, EmittingFacets, UniformSky>;

} // namespace PhotonTransport
