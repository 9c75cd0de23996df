// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace PhotonTransport
{

/// Luminous intensity around a lamp, bilinear in two angles about a pole; dark where no angle is
/// given. Kinds of coordinates by IESNA LM-63 and CIE 121, for a lamp that aims along a:
///  - C: the pole is the aim, (x, y) span the plane across it; d = cos p a + sin p (cos z x + sin z
///    y), p the vertical angle.
///  - A: the pole is y, the lamp's up; p = 90 - vertical angle, z = horizontal angle;
///    d = cos p y + sin p (cos z a + sin z x).
///  - B: the pole is x, the lamp's side; p = 90 - horizontal angle, z = vertical angle;
///    d = cos p x + sin p (cos z a + sin z y).
struct PhotometricSolid
{
  enum class Type
  {
    C,
    B,
    A
  };

  Type type = Type::C;
  std::vector<double> polar; ///< p, degrees, rising, in [0, 180]; two or more.
  /// z, degrees, rising; two or more. They cover at most 360 degrees and may begin below 0 or end
  /// above 360.
  std::vector<double> azimuth;
  std::vector<double> candela; ///< [azimuth][polar], finite, >= 0, with all factors of the file.

  double ratedFlux = 0.0;  ///< lm of the file's bare lamps together; 0 for absolute photometry.
  double inputPower = 0.0; ///< W; 0 if not given.
  /// Size of the luminous opening, m; a diameter where it is round; 0: a point. Width and length
  /// are as the file calls them: the length lies in the plane of 0 degrees in IES files and in that
  /// of 90 degrees in EULUMDAT.
  double width = 0.0, length = 0.0, height = 0.0;
  std::string description; ///< Manufacturer, name and number as far as given, one line, UTF-8.
  /// What the reader of the file assumed, or found odd: one sentence each. None for most files.
  std::vector<std::string> notes;
};

/// The flux of the bilinear solid, integrated exactly, lm.
double Flux(const PhotometricSolid& solid);

/// The intensity, cd, towards polar angle and azimuth, degrees. Whole turns may be added to the
/// azimuth.
double Intensity(const PhotometricSolid& solid, double polar, double azimuth);

/// The unit vector to polar angle and azimuth, degrees, for a lamp that aims along a = -z and has
/// its x and y along +x and +y.
glm::dvec3 PhotometricDirection(PhotometricSolid::Type type, double polar, double azimuth);

} // namespace PhotonTransport
