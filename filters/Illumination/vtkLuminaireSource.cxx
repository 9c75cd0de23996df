// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLuminaireSource.h"

#include "Illumination/luminaires/LampProperties.h"
#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/luminaires/LuminaireGeometry.h"
#include "Illumination/luminaires/LuminairePlace.h"
#include "Illumination/pipeline/InputError.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/photometry/PhotometricFile.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>
#include <type_traits>

using namespace Illumination;

vtkStandardNewMacro(vtkLuminaireSource);

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

/// Refuses amounts that Dimming, which is applied later, would make infinite.
double Dimmable(double amount, const char* property, vtkLuminaireSource* source)
{
  const double dimming = Amount(source->GetDimming(), "Dimming");
  if (!std::isfinite(Amount(amount, property) * dimming))
  {
    Refuse(property, Text(amount), ("finite times Dimming, " + Text(dimming)).c_str());
  }
  return amount;
}

double FluxOf(vtkLuminaireSource* source)
{
  return Dimmable(source->GetLuminousFlux(), "LuminousFlux", source);
}

double IlluminanceOf(vtkLuminaireSource* source)
{
  return Dimmable(source->GetIlluminance(), "Illuminance", source);
}

double SpotHalfAngleOf(vtkLuminaireSource* source)
{
  const double angle = source->GetSpotHalfAngle();
  if (Amount(source->GetSpotExponent(), "SpotExponent") > 0.0 && angle > 90.0)
  {
    Refuse("SpotHalfAngle", Text(angle), "at most 90 with a SpotExponent above 0");
  }
  return Above0(angle, 180.0, "SpotHalfAngle");
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

PhotometricSolid SolidOf(vtkLuminaireSource* source)
{
  const std::string path = source->GetFileName();
  if (path.empty())
  {
    throw InputError("FileName is empty; a photometric file (.ies, .ldt) is wanted");
  }
  try
  {
    return ReadPhotometricFile(path);
  }
  catch (const PhotometricFileError& error)
  {
    throw InputError("FileName '" + path + "', " + error.what());
  }
}

// The types are the kinds of lamps in their order, without those of surfaces, which come last.
static_assert(std::is_same_v<std::variant_alternative_t<vtkLuminaireSource::NUMBER_OF_TYPES, Lamp>,
                EmittingFacets>,
  "vtkLuminaireSource::Types has one type for each kind of lamp");

Lamp LampOf(vtkLuminaireSource* s)
{
  // A hemisphere of luminance L gives pi L on the ground (Lambert).
  return DescribedLamp(static_cast<std::size_t>(s->GetType()),
    LampProperties(
      { { "LuminairePosition", [s](int c) { return PositionOf(s)[c]; } },
        { "LuminaireDirection", [s](int c) { return DirectionOf(s)[c]; } },
        { "LuminaireSize", [s](int part) { return SizeOf(s, part); } },
        { "LuminousFlux", [s](int) { return FluxOf(s); } },
        { "LuminaireIlluminance", [s](int) { return IlluminanceOf(s); } },
        { "SpotHalfAngle", [s](int) { return SpotHalfAngleOf(s); } },
        { "SpotExponent", [s](int) { return s->GetSpotExponent(); } },
        { "SkyUp", [](int c) { return c == 2 ? 1.0 : 0.0; } },
        { "SkyLuminance", [s](int) { return IlluminanceOf(s) / vtkMath::Pi(); } },
        { "SkyIsWholeSphere", [](int) { return 0.0; } },
        { "SkyType", [s](int) { return SkyTypeOf(s); } },
        { "SunDirection", [s](int c) { return SunOf(s)[c]; } },
        { "LuminaireRotation", [s](int) { return Finite(s->GetRotation(), "Rotation"); } },
        { "PhotometricScale", [](int) { return 1.0; } } },
      [s] { return SolidOf(s); }));
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

/// As the glyph shows it: a dome has the luminances after dimming.
Lamp ShownLamp(const Luminaire& luminaire)
{
  Lamp lamp = luminaire.lamp;
  if (auto* sky = std::get_if<CieSky>(&lamp))
  {
    sky->horizontalIlluminance *= luminaire.dimming;
  }
  return lamp;
}

} // namespace

vtkLuminaireSource::vtkLuminaireSource()
{
  this->SetNumberOfInputPorts(0);
}

int vtkLuminaireSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkPolyData* out = vtkPolyData::GetData(output);
  try
  {
    const LuminaireGlyph glyph = this->MakeGlyph();
    const PhotonTransport::Luminaire luminaire = this->MakeLuminaire();
    out->ShallowCopy(LuminaireGeometry(ShownLamp(luminaire), glyph));
    AddLuminaire(out->GetFieldData(), luminaire);
    RememberPlace(out);
  }
  catch (const std::exception& error)
  {
    out->Initialize();
    AddLuminaireError(out->GetFieldData(), error.what());
    vtkErrorMacro(<< error.what());
  }
  return 1; // as vtkIlluminationMap does: an error is said once
}

Luminaire vtkLuminaireSource::MakeLuminaire()
{
  return { LampOf(this), this->LuminaireName, ColourOf(this), Amount(this->Dimming, "Dimming") };
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

void vtkLuminaireSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* values, int count)
  {
    os << indent << name << ":";
    std::for_each(values, values + count, [&](double value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "Type: " << this->Type << "\n";
  os << indent << "LuminaireName: " << this->LuminaireName << "\n";
  print("Position", this->Position, 3);
  print("Direction", this->Direction, 3);
  print("Size", this->Size, 2);
  print("Rotation", &this->Rotation, 1);
  print("SpotHalfAngle", &this->SpotHalfAngle, 1);
  print("SpotExponent", &this->SpotExponent, 1);
  print("LuminousFlux", &this->LuminousFlux, 1);
  print("Illuminance", &this->Illuminance, 1);
  os << indent << "SkyType: " << this->SkyType << "\n";
  print("SunAltitude", &this->SunAltitude, 1);
  print("SunAzimuth", &this->SunAzimuth, 1);
  os << indent << "FileName: " << this->FileName << "\n";
  print("Dimming", &this->Dimming, 1);
  print("LightColour", this->LightColour, 3);
  print("GlyphSize", &this->GlyphSize, 1);
}
