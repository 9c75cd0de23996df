// SPDX-License-Identifier: BSD-3-Clause
// The properties of vtkLuminaireSource in the core's terms.
#include "vtkLuminaireSource.h"

#include "Illumination/luminaires/LuminaireGeometry.h"
#include "Illumination/pipeline/InputError.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/photometry/PhotometricFile.h"

#include "vtkMath.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using namespace PhotonTransport;

[[noreturn]] void Refuse(const char* property, const std::string& value, const char* wanted)
{
  throw InputError(std::string(property) + " is " + value + "; it must be " + wanted);
}

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string Text(const double v[3])
{
  return '(' + Text(v[0]) + ", " + Text(v[1]) + ", " + Text(v[2]) + ')';
}

bool IsFinite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double Finite(double value, const char* property)
{
  if (!std::isfinite(value))
  {
    Refuse(property, Text(value), "finite");
  }
  return value;
}

double Amount(double value, const char* property)
{
  if (!(value >= 0.0 && std::isfinite(value)))
  {
    Refuse(property, Text(value), "0 or more, and finite");
  }
  return value;
}

/// In (0, largest].
double Above0(double value, double largest, const char* property)
{
  if (!(value > 0.0 && value <= largest))
  {
    Refuse(property, Text(value), ("above 0 and at most " + Text(largest)).c_str());
  }
  return value;
}

glm::dvec3 PositionOf(vtkLuminaireSource* source)
{
  const double* v = source->GetPosition();
  if (!IsFinite(v))
  {
    Refuse("Position", Text(v), "finite");
  }
  return { v[0], v[1], v[2] };
}

glm::dvec3 DirectionOf(vtkLuminaireSource* source)
{
  const double* v = source->GetDirection();
  if (!IsFinite(v) || (v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0))
  {
    Refuse("Direction", Text(v), "finite and not zero");
  }
  return { v[0], v[1], v[2] };
}

double SizeOf(vtkLuminaireSource* source, int part)
{
  const double size = source->GetSize()[part];
  if (!(size >= 0.0 && size <= 1e30))
  {
    Refuse(part == 0 ? "Size[0]" : "Size[1]", Text(size), "within [0, 1e30]");
  }
  return size;
}

double Dimmed(double amount, const char* property, vtkLuminaireSource* source)
{
  const double dimming = Amount(source->GetDimming(), "Dimming");
  const double dimmed = Amount(amount, property) * dimming;
  if (!std::isfinite(dimmed))
  {
    Refuse(property, Text(amount), ("finite times Dimming, " + Text(dimming)).c_str());
  }
  return dimmed;
}

double FluxOf(vtkLuminaireSource* source)
{
  return Dimmed(source->GetLuminousFlux(), "LuminousFlux", source);
}

double IlluminanceOf(vtkLuminaireSource* source)
{
  return Dimmed(source->GetIlluminance(), "Illuminance", source);
}

SpotLamp SpotOf(vtkLuminaireSource* source)
{
  const double exponent = Amount(source->GetSpotExponent(), "SpotExponent");
  const double angle = source->GetSpotHalfAngle();
  if (exponent > 0.0 && angle > 90.0)
  {
    Refuse("SpotHalfAngle", Text(angle), "at most 90 with a SpotExponent above 0");
  }
  const double halfAngle = vtkMath::RadiansFromDegrees(Above0(angle, 180.0, "SpotHalfAngle"));
  return { PositionOf(source), DirectionOf(source), halfAngle, exponent, FluxOf(source) };
}

/// From the ground to the sun: azimuth clockwise from north, +y, seen from above.
glm::dvec3 SunOf(vtkLuminaireSource* source)
{
  const double altitude =
    vtkMath::RadiansFromDegrees(Above0(source->GetSunAltitude(), 90.0, "SunAltitude"));
  const double azimuth = vtkMath::RadiansFromDegrees(Finite(source->GetSunAzimuth(), "SunAzimuth"));
  return { std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth),
    std::sin(altitude) };
}

int SkyTypeOf(vtkLuminaireSource* source)
{
  const int type = source->GetSkyType();
  if (type < 1 || type > 16)
  {
    Refuse("SkyType", std::to_string(type), "within 1 to 16");
  }
  return type;
}

PhotometricLamp PhotometricOf(vtkLuminaireSource* source)
{
  PhotometricLamp lamp;
  lamp.position = PositionOf(source);
  lamp.direction = DirectionOf(source);
  lamp.rotation = vtkMath::RadiansFromDegrees(Finite(source->GetRotation(), "Rotation"));
  lamp.scale = Amount(source->GetDimming(), "Dimming");
  const std::string path = source->GetFileName();
  if (path.empty())
  {
    throw InputError("FileName is empty; a photometric file (.ies, .ldt) is wanted");
  }
  try
  {
    lamp.solid = ReadPhotometricFile(path);
  }
  catch (const PhotometricFileError& error)
  {
    throw InputError("FileName '" + path + "', " + error.what());
  }
  return lamp;
}

Lamp LampOf(vtkLuminaireSource* source)
{
  switch (source->GetType())
  {
    case vtkLuminaireSource::POINT:
      return PointLamp{ PositionOf(source), FluxOf(source) };
    case vtkLuminaireSource::LAMBERTIAN_POINT:
      return LambertianPointLamp{ PositionOf(source), DirectionOf(source), FluxOf(source) };
    case vtkLuminaireSource::SPOT:
      return SpotOf(source);
    case vtkLuminaireSource::RECTANGLE:
      return RectangleLamp{ PositionOf(source), DirectionOf(source), SizeOf(source, 0),
        SizeOf(source, 1), FluxOf(source) };
    case vtkLuminaireSource::DISK:
      return DiskLamp{ PositionOf(source), DirectionOf(source), SizeOf(source, 0), FluxOf(source) };
    case vtkLuminaireSource::SPHERE:
      return SphereLamp{ PositionOf(source), SizeOf(source, 0), FluxOf(source) };
    case vtkLuminaireSource::LINE:
      return LineLamp{ PositionOf(source), DirectionOf(source), SizeOf(source, 0), FluxOf(source) };
    case vtkLuminaireSource::UNIFORM_SKY:
      // A hemisphere of luminance L gives pi L on the ground (Lambert).
      return UniformSky{ { 0.0, 0.0, 1.0 }, IlluminanceOf(source) / vtkMath::Pi(), false };
    case vtkLuminaireSource::CIE_SKY:
      return CieSky{ { 0.0, 0.0, 1.0 }, SkyTypeOf(source), SunOf(source), IlluminanceOf(source) };
    case vtkLuminaireSource::PHOTOMETRIC_FILE:
      return PhotometricOf(source);
    default:
      return ParallelLight{ DirectionOf(source), IlluminanceOf(source) };
  }
}

/// In a scale of its own, so that the largest number fits a float.
Colour ColourOf(vtkLuminaireSource* source)
{
  const double* v = source->GetLightColour();
  const auto [least, largest] = std::minmax({ v[0], v[1], v[2] });
  if (!IsFinite(v) || least < 0.0 || largest == 0.0)
  {
    Refuse("LightColour", Text(v), "0 or more, finite, and not all 0");
  }
  return Colour(glm::dvec3(v[0], v[1], v[2]) / largest);
}

} // namespace

Luminaire vtkLuminaireSource::MakeLuminaire()
{
  return { LampOf(this), this->LuminaireName, ColourOf(this) };
}

LuminaireGlyph vtkLuminaireSource::MakeGlyph()
{
  const double size = this->GlyphSize;
  if (!(size >= 1e-30 && size <= 1e30))
  {
    Refuse("GlyphSize", Text(size), "within [1e-30, 1e30]");
  }
  return { PositionOf(this), size };
}
