// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminaireFields.h"

#include "Illumination/luminaires/EmittingSurface.h"
#include "Illumination/luminaires/LuminairePlace.h"
#include "Illumination/luminaires/MovedLamp.h"
#include "Illumination/pipeline/FieldValues.h"
#include "Illumination/pipeline/InputError.h"

#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

namespace
{

using namespace PhotonTransport;

constexpr const char* Type = "LuminaireType";
constexpr const char* Error = "LuminaireError";

// The values of each lamp. FieldWriter and FieldReader share these functions. A value that fields
// hold in another unit or type is converted, passed, and converted back.

template <typename Fields>
void PassAngle(const Fields& fields, const char* name, double& radians)
{
  double degrees = vtkMath::DegreesFromRadians(radians);
  fields(name, degrees);
  radians = vtkMath::RadiansFromDegrees(degrees);
}

template <typename Fields>
void Pass(const Fields& fields, ParallelLight& lamp)
{
  fields("LuminaireDirection", lamp.direction);
  fields("LuminaireIlluminance", lamp.illuminance);
}

template <typename Fields>
void Pass(const Fields& fields, PointLamp& lamp)
{
  fields("LuminairePosition", lamp.position);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, LambertianPointLamp& lamp)
{
  fields("LuminairePosition", lamp.position);
  fields("LuminaireDirection", lamp.direction);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, SpotLamp& lamp)
{
  fields("LuminairePosition", lamp.position);
  fields("LuminaireDirection", lamp.direction);
  PassAngle(fields, "SpotHalfAngle", lamp.halfAngle);
  fields("SpotExponent", lamp.exponent);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, RectangleLamp& lamp)
{
  fields("LuminairePosition", lamp.centre);
  fields("LuminaireDirection", lamp.direction);
  std::vector<double> size{ lamp.width, lamp.height };
  fields("LuminaireSize", size);
  if (size.size() != 2)
  {
    RefuseField("LuminaireSize", "has " + std::to_string(size.size()) + " values; 2 are wanted");
  }
  lamp.width = size[0];
  lamp.height = size[1];
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, DiskLamp& lamp)
{
  fields("LuminairePosition", lamp.centre);
  fields("LuminaireDirection", lamp.direction);
  fields("LuminaireSize", lamp.radius);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, SphereLamp& lamp)
{
  fields("LuminairePosition", lamp.centre);
  fields("LuminaireSize", lamp.radius);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, LineLamp& lamp)
{
  fields("LuminairePosition", lamp.centre);
  fields("LuminaireDirection", lamp.axis);
  fields("LuminaireSize", lamp.length);
  fields("LuminousFlux", lamp.flux);
}

template <typename Fields>
void Pass(const Fields& fields, UniformSky& sky)
{
  fields("SkyUp", sky.up);
  fields("SkyLuminance", sky.luminance);
  double whole = sky.wholeSphere ? 1.0 : 0.0;
  fields("SkyIsWholeSphere", whole);
  sky.wholeSphere = whole != 0.0;
}

template <typename Fields>
void Pass(const Fields& fields, CieSky& sky)
{
  fields("SkyUp", sky.up);
  double type = sky.type;
  fields("SkyType", type);
  if (!(type >= 1.0 && type <= 16.0 && type == std::floor(type)))
  {
    RefuseField(
      "SkyType", "is " + std::to_string(type) + "; it must be a whole number from 1 to 16");
  }
  sky.type = static_cast<int>(type);
  fields("SunDirection", sky.sun);
  fields("LuminaireIlluminance", sky.horizontalIlluminance);
}

const std::array<std::string, 3> SolidTypes{ "C", "B", "A" }; // as PhotometricSolid::Type counts

/// What PhotometricSolid promises, on which its functions rely.
void Check(const PhotometricSolid& solid)
{
  const std::pair<const char*, const std::vector<double>&> grid[] = {
    { "PhotometricPolar", solid.polar }, { "PhotometricAzimuth", solid.azimuth }
  };
  for (const auto& [name, angles] : grid)
  {
    if (angles.size() < 2 ||
      std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) != angles.end())
    {
      RefuseField(name, "does not hold two or more rising angles");
    }
  }
  if (solid.polar.front() < 0.0 || solid.polar.back() > 180.0)
  {
    RefuseField("PhotometricPolar", "leaves [0, 180] degrees");
  }
  if (solid.azimuth.back() - solid.azimuth.front() > 360.0)
  {
    RefuseField("PhotometricAzimuth", "covers more than 360 degrees");
  }
  const std::size_t directions = solid.azimuth.size() * solid.polar.size();
  if (solid.candela.size() != directions)
  {
    RefuseField("PhotometricCandela",
      "has " + std::to_string(solid.candela.size()) + " values; " + std::to_string(directions) +
        " are wanted, one for each azimuth and polar angle");
  }
  if (*std::min_element(solid.candela.begin(), solid.candela.end()) < 0.0)
  {
    RefuseField("PhotometricCandela", "has values below 0");
  }
}

template <typename Fields>
void Pass(const Fields& fields, PhotometricSolid& solid)
{
  std::string type = SolidTypes[static_cast<std::size_t>(solid.type)];
  fields("PhotometricType", type);
  const auto found = std::find(SolidTypes.begin(), SolidTypes.end(), type);
  if (found == SolidTypes.end())
  {
    RefuseField("PhotometricType", "is '" + type + "'; C, B and A are known");
  }
  solid.type = static_cast<PhotometricSolid::Type>(found - SolidTypes.begin());
  fields("PhotometricPolar", solid.polar);
  fields("PhotometricAzimuth", solid.azimuth);
  fields("PhotometricCandela", solid.candela);
  Check(solid);
  fields("PhotometricRatedFlux", solid.ratedFlux);
  fields("PhotometricInputPower", solid.inputPower);
  glm::dvec3 opening{ solid.width, solid.length, solid.height };
  fields("PhotometricOpening", opening);
  solid.width = opening.x;
  solid.length = opening.y;
  solid.height = opening.z;
  fields("PhotometricDescription", solid.description);
  fields("PhotometricNotes", solid.notes);
}

template <typename Fields>
void Pass(const Fields& fields, PhotometricLamp& lamp)
{
  fields("LuminairePosition", lamp.position);
  fields("LuminaireDirection", lamp.direction);
  PassAngle(fields, "LuminaireRotation", lamp.rotation);
  fields("PhotometricScale", lamp.scale);
  Pass(fields, lamp.solid);
}

// Surfaces describe themselves.
template <typename Fields>
void Pass(const Fields&, EmittingFacets&)
{
}
template <typename Fields>
void Pass(const Fields&, EmittingMesh&)
{
}

template <typename Fields>
void Pass(const Fields& fields, Luminaire& luminaire)
{
  fields("LuminaireName", luminaire.name);
  glm::dvec3 colour(luminaire.colour);
  fields("LuminaireColour", colour);
  const auto [least, largest] = std::minmax({ colour.x, colour.y, colour.z });
  if (least < 0.0 || !(largest > 0.0) || largest > VTK_FLOAT_MAX)
  {
    std::ostringstream text;
    text << "is (" << colour.x << ", " << colour.y << ", " << colour.z
         << "); its parts must be 0 or more, and one above 0";
    RefuseField("LuminaireColour", text.str());
  }
  luminaire.colour = Colour(colour);
  std::visit([&](auto& lamp) { Pass(fields, lamp); }, luminaire.lamp);
}

struct Kind
{
  const char* name; ///< The LuminaireType.
  Lamp lamp;
};

const std::vector<Kind>& Kinds()
{
  static const std::vector<Kind> kinds{ { "Parallel", ParallelLight() }, { "Point", PointLamp() },
    { "Lambertian Point", LambertianPointLamp() }, { "Spot", SpotLamp() },
    { "Rectangle", RectangleLamp() }, { "Disk", DiskLamp() }, { "Sphere", SphereLamp() },
    { "Line", LineLamp() }, { "Uniform Sky", UniformSky() }, { "CIE Sky", CieSky() },
    { "Photometric", PhotometricLamp() } };
  return kinds;
}

Luminaire ReadFields(const FieldReader& fields)
{
  std::string type;
  fields(Type, type);
  std::string known;
  for (const Kind& kind : Kinds())
  {
    if (type == kind.name)
    {
      Luminaire luminaire{ kind.lamp, {} };
      Pass(fields, luminaire);
      return luminaire;
    }
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  RefuseField(Type, "is '" + type + "'; known types are " + known);
}

} // namespace

void AddLuminaire(vtkFieldData* fields, const Luminaire& luminaire)
{
  const auto kind = std::find_if(Kinds().begin(), Kinds().end(),
    [&](const Kind& k) { return k.lamp.index() == luminaire.lamp.index(); });
  if (kind == Kinds().end())
  {
    throw InputError("emitting surfaces are not described by field data");
  }
  const FieldWriter writer(fields);
  writer(Type, std::string(kind->name));
  Luminaire passed = luminaire;
  Pass(writer, passed);
}

void AddLuminaireError(vtkFieldData* fields, const std::string& error)
{
  AddArray(fields, Error, std::vector<std::string>{ error });
}

bool HasLuminaireFields(vtkFieldData* fields)
{
  return fields->HasArray(Type) || fields->HasArray(Error);
}

std::optional<Luminaire> ReadLuminaire(vtkPolyData* data)
{
  vtkFieldData* fields = data->GetFieldData();
  if (fields->HasArray(Error))
  {
    std::string error;
    FieldReader reader(fields);
    reader(Error, error);
    throw InputError("its source has an error: " + error);
  }
  if (HasLuminairePoints(data) && !fields->HasArray(Type))
  {
    throw InputError("it has a luminaire's points but lost the field data that describe it, in a "
                     "filter that does not keep them; connect the luminaire before that filter");
  }
  if (fields->HasArray(Type))
  {
    Luminaire luminaire = ReadFields(FieldReader(fields));
    if (data->GetCellData()->HasArray("Exitance"))
    {
      throw InputError("it has both the field data of a luminaire and a cell array 'Exitance'; "
                       "remove one of them to say which of them shines");
    }
    luminaire.lamp = Moved(luminaire.lamp, MotionOf(data));
    return luminaire;
  }
  return ReadEmittingSurface(data);
}
