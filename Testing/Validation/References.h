// SPDX-License-Identifier: BSD-3-Clause
// What the validation compares with: closed forms, and quadrature of the definitions.
#pragma once

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace References
{

constexpr double Pi = 3.14159265358979323846;

/// Configuration factor from a point with a unit normal to a polygon that lies above its horizon:
/// Lambert's formula, F = 1/(2 pi) sum of the angles that the edges subtend times the cosine to the
/// normal of the plane through point and edge (Howell, "A Catalog of Radiation Heat Transfer
/// Configuration Factors", introduction to the contour integral).
double ConfigurationFactor(
  const glm::dvec3& point, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon);

/// Solid angle of a rectangle of half-sides a and b, seen from a distance h above its middle.
double RectangleSolidAngle(double a, double b, double h);

/// Transmittance of a clear sheet for unpolarised light: the mean over both polarisations of
/// (1 - r) / (1 + r), r Fresnel's reflectance of one face.
double SheetTransmittance(double cosine, double index);

/// Integral over [from, to] by 20 Gauss-Legendre points.
double Integral(const std::function<double(double)>& f, double from, double to);

/// corner + s u + t v with s and t in [0, 1].
struct Rectangle
{
  glm::dvec3 corner, u, v;
};

/// Luminance in a direction (unit, to the sky).
using Luminance = std::function<double(const glm::dvec3&)>;

/// Integral of g E over a receiver that gets light of a sky through an opening in an otherwise
/// closed black room. @param index Of a clear sheet in the opening; 1: none.
/// @param end How far in t the opening sees the sky from a point of the receiver; all of it if
/// empty.
double ReceiverIntegral(const Rectangle& receiver, const Rectangle& opening, const Luminance& sky,
  double index, const std::function<double(const glm::dvec3& point)>& g,
  const std::function<double(const glm::dvec3& point)>& end = {});

/// The sky's luminance, cd/m^2, for a horizontal illuminance, lx; its integral by quadrature.
/// @param sun Unit, to the sun; up is +z.
Luminance CieSkyLuminance(int type, const glm::dvec3& sun, double horizontalIlluminance);

} // namespace References
