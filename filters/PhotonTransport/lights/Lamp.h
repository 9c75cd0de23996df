// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <glm/vec3.hpp>

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

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
  double halfAngle = 0.5; ///< Axis to edge, radians, (0, pi]; at most pi/2 if the exponent is > 0.
  double exponent = 0.0;  ///< n >= 0; 0 is even light.
  double flux = 1000.0;
};

/// A Lambertian panel that shines to one side and stops no photons itself.
struct RectangleLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double width = 1.0;
  double height = 1.0;
  double flux = 1000.0;
  /// The direction of the width, of any length, not along `direction`. Zero: along z x direction,
  /// or along x for vertical light. The height runs along direction x width.
  glm::dvec3 across{ 0.0 };
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

/// The sky by ISO 15469:2004 / CIE S 011:2003, above the horizon only.
struct CieSky
{
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
  int type = 1;                       ///< 1 to 15; 16 is the traditional overcast sky.
  glm::dvec3 sun{ 0.0, -1.0, 1.0 };   ///< From the ground to the sun, above the horizon.
  double horizontalIlluminance = 1e4; ///< lx of an unshaded horizontal plane, without the sun.
};

/// A ball of uniform luminance that stops no photons itself.
struct SphereLamp
{
  glm::dvec3 centre{ 0.0 };
  double radius = 1.0;
  double flux = 1000.0;
};

/// A thin diffuse tube: intensity falls as the sine of the angle to its axis.
struct LineLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 axis{ 1.0, 0.0, 0.0 };
  double length = 1.0;
  double flux = 1000.0;
};

/// A point-like lamp with the intensities of a photometric file.
struct PhotometricLamp
{
  glm::dvec3 position{ 0.0 };
  /// Where the lamp aims: the nadir of type C, the centre of types A and B. For a lamp that aims
  /// along -z with rotation 0, azimuth 0 of type C is +x and azimuth 90 degrees is +y. Another aim
  /// turns the lamp there by the shortest way (about x for +z).
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  /// Radians by which the lamp is turned about its aim, from +x towards +y, while it aims along -z.
  double rotation = 0.0;
  PhotometricSolid solid;
  double scale = 1.0; ///< Factor on the solid's intensities, >= 0.
};

/// Triangles that shine diffusely to the side round which their corners run counter-clockwise.
/// They stop no photons.
struct EmittingMesh
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> facets;
  std::vector<float> exitance; ///< lm/m^2, one a facet, >= 0.
};

using Lamp =
  std::variant<ParallelLight, PointLamp, LambertianPointLamp, SpotLamp, RectangleLamp, DiskLamp,
    EmittingFacets, UniformSky, CieSky, SphereLamp, LineLamp, PhotometricLamp, EmittingMesh>;

/// A lamp with its name and the colour of its light.
struct Luminaire
{
  Lamp lamp;
  std::string name;
  /// The colour of the light, in any scale: it does not change the flux. It is not used for facets
  /// that have colours of their own (Surface::exitanceColour).
  Colour colour{ 1.0f };
};

/// All the light of a scene. At least one lamp.
struct Lighting
{
  std::vector<Luminaire> luminaires;

  Lighting() = default;
  /// A single lamp, of any kind, is a lighting too.
  template <typename AnyLamp,
    typename = std::enable_if_t<std::is_constructible_v<Lamp, const AnyLamp&>>>
  Lighting(const AnyLamp& lamp)
    : luminaires{ Luminaire{ lamp, {}, Colour(1.0f) } }
  {
  }
};

} // namespace PhotonTransport
