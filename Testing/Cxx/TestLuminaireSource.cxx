// SPDX-License-Identifier: BSD-3-Clause
// The luminaire source: each type's description comes back out of the field data with all its
// values, its geometry is where and as large as it should be, and bad values give one error.
#include "TestTools.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/pipeline/InputError.h"
#include "vtkLuminaireSource.h"

#include "vtkNew.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace
{

using namespace PhotonTransport;

constexpr double Pi = 3.14159265358979323846;
/// Degrees to radians and back: four roundings, of the values and of the two factors.
constexpr double AngleRounding = 4.0 * std::numeric_limits<double>::epsilon();

vtkSmartPointer<vtkLuminaireSource> Source(int type)
{
  auto source = vtkSmartPointer<vtkLuminaireSource>::New();
  source->SetType(type);
  source->SetLuminaireName("over the desk");
  source->SetPosition(1.0, 2.0, 3.0);
  source->SetDirection(2.0, 0.0, 0.0);
  source->SetSize(0.5, 0.25);
  source->SetRotation(33.0);
  source->SetSpotHalfAngle(60.0);
  source->SetSpotExponent(1.5);
  source->SetLuminousFlux(800.0);
  source->SetIlluminance(600.0);
  source->SetSkyType(12);
  source->SetSunAltitude(30.0);
  source->SetSunAzimuth(90.0);
  source->SetDimming(0.5);
  source->SetLightColour(2.0, 4.0, 1.0);
  source->SetGlyphSize(0.75);
  return source;
}

const glm::dvec3 Position(1.0, 2.0, 3.0);
const glm::dvec3 Direction(2.0, 0.0, 0.0);
constexpr double Flux = 400.0;        // dimmed
constexpr double Illuminance = 300.0; // dimmed

/// The lamp as the field data describe it; all values 0 if they describe another type.
template <typename Lamp>
Lamp Described(vtkLuminaireSource* source, Checks& check)
{
  source->Update();
  const auto luminaire = ReadLuminaire(source->GetOutput());
  const std::string type = "type " + std::to_string(source->GetType());
  check(luminaire && std::holds_alternative<Lamp>(luminaire->lamp), type + " comes back");
  check(luminaire && luminaire->name == "over the desk", type + " keeps its name");
  check(luminaire && luminaire->colour == Colour(0.5f, 1.0f, 0.25f), type + " keeps its colour");
  const Lamp* lamp = luminaire ? std::get_if<Lamp>(&luminaire->lamp) : nullptr;
  return lamp ? *lamp : Lamp{};
}

/// The geometry's bounds; a polyhedron's round sides may lie `inside` the sphere or circle.
void CheckBounds(vtkLuminaireSource* source, const glm::dvec3& low, const glm::dvec3& high,
  Checks& check, double inside = 0.0)
{
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  const double rounding = 1e-6; // of arrows, which VTK makes of floats
  for (int axis = 0; axis < 3; ++axis)
  {
    const double below = bounds[2 * axis] - low[axis];
    const double above = high[axis] - bounds[2 * axis + 1];
    for (const double gap : { below, above })
    {
      check(gap >= -rounding && gap <= inside + rounding,
        "type " + std::to_string(source->GetType()) + ": bounds of axis " + std::to_string(axis) +
          " are off by " + std::to_string(gap));
    }
  }
}

void CheckPoints(Checks& check)
{
  auto source = Source(vtkLuminaireSource::PARALLEL);
  const auto parallel = Described<ParallelLight>(source, check);
  check(parallel.direction == Direction && parallel.illuminance == Illuminance, "parallel light");
  const double tip = 0.1 * 0.75; // vtkArrowSource's radius
  CheckBounds(source, Position - glm::dvec3(0.0, tip, tip), Position + glm::dvec3(0.75, tip, tip),
    check, tip * (1.0 - std::cos(Pi / 48.0)));

  source = Source(vtkLuminaireSource::POINT);
  const auto point = Described<PointLamp>(source, check);
  check(point.position == Position && point.flux == Flux, "point lamp");
  CheckBounds(source, Position - 0.375, Position + 0.375, check);

  source = Source(vtkLuminaireSource::LAMBERTIAN_POINT);
  const auto flat = Described<LambertianPointLamp>(source, check);
  check(flat.position == Position && flat.direction == Direction && flat.flux == Flux, "flat lamp");
  CheckBounds(source, Position - glm::dvec3(0.0, tip, tip), Position + glm::dvec3(0.75, tip, tip),
    check, tip * (1.0 - std::cos(Pi / 48.0)));

  source = Source(vtkLuminaireSource::SPOT);
  const auto spot = Described<SpotLamp>(source, check);
  check(spot.position == Position && spot.direction == Direction && spot.flux == Flux, "spot");
  check(std::fabs(spot.halfAngle - Pi / 3.0) <= AngleRounding * Pi / 3.0, "spot's angle");
  check(spot.exponent == 1.5, "spot's exponent");
  const double radius = 0.75 * std::sqrt(0.75);
  CheckBounds(source, Position - glm::dvec3(0.0, radius, radius),
    Position + glm::dvec3(0.75, radius, radius), check, radius * (1.0 - std::cos(Pi / 48.0)));
}

/// Whether the first polygon faces the side to which the panel shines.
bool FacesItsLight(vtkPolyData* panel)
{
  double normal[3];
  vtkCell* cell = panel->GetCell(panel->GetNumberOfLines());
  vtkPolygon::ComputeNormal(cell->GetPoints(), normal);
  return normal[0] > 0.999;
}

void CheckAreas(Checks& check)
{
  auto source = Source(vtkLuminaireSource::RECTANGLE);
  const auto rectangle = Described<RectangleLamp>(source, check);
  check(rectangle.centre == Position && rectangle.direction == Direction, "rectangle's place");
  check(rectangle.width == 0.5 && rectangle.height == 0.25 && rectangle.flux == Flux, "rectangle");
  // The width along z x direction = y; a line along the light, half as long as the mean side.
  CheckBounds(source, Position - glm::dvec3(0.0, 0.25, 0.125),
    Position + glm::dvec3(0.1875, 0.25, 0.125), check);
  check(FacesItsLight(source->GetOutput()), "the rectangle faces its light");
  source->SetDirection(0.0, 0.0, -1.0);
  source->Update();
  CheckBounds(source, Position - glm::dvec3(0.25, 0.125, 0.1875),
    Position + glm::dvec3(0.25, 0.125, 0.0), check);

  source = Source(vtkLuminaireSource::DISK);
  const auto disk = Described<DiskLamp>(source, check);
  check(disk.centre == Position && disk.direction == Direction, "disk's place");
  check(disk.radius == 0.5 && disk.flux == Flux, "disk");
  CheckBounds(source, Position - glm::dvec3(0.0, 0.5, 0.5), Position + glm::dvec3(0.5, 0.5, 0.5),
    check, 0.5 * (1.0 - std::cos(Pi / 48.0)));
  check(FacesItsLight(source->GetOutput()), "the disk faces its light");

  source = Source(vtkLuminaireSource::SPHERE);
  const auto sphere = Described<SphereLamp>(source, check);
  check(sphere.centre == Position && sphere.radius == 0.5 && sphere.flux == Flux, "sphere");
  CheckBounds(source, Position - 0.5, Position + 0.5, check);

  source = Source(vtkLuminaireSource::LINE);
  const auto line = Described<LineLamp>(source, check);
  check(line.centre == Position && line.axis == Direction, "line's place");
  check(line.length == 0.5 && line.flux == Flux, "line");
  CheckBounds(
    source, Position - glm::dvec3(0.25, 0.0, 0.0), Position + glm::dvec3(0.25, 0.0, 0.0), check);
}

/// All light from one point: drawn as point-like lamps are.
void CheckWithoutSize(Checks& check)
{
  for (const int type : { vtkLuminaireSource::RECTANGLE, vtkLuminaireSource::DISK,
         vtkLuminaireSource::SPHERE, vtkLuminaireSource::LINE })
  {
    auto source = Source(type);
    source->SetSize(0.0, 0.0);
    source->Update();
    double bounds[6];
    source->GetOutput()->GetBounds(bounds);
    check(std::fabs(bounds[1] - bounds[0] - 0.75) < 1e-6,
      "type " + std::to_string(type) + " without a size is as long as its glyph");
    check(ReadLuminaire(source->GetOutput()).has_value(), "and is a lamp");
  }
}

void CheckSkies(Checks& check)
{
  const glm::dvec3 up(0.0, 0.0, 1.0);
  auto source = Source(vtkLuminaireSource::UNIFORM_SKY);
  const auto uniform = Described<UniformSky>(source, check);
  check(uniform.up == up && !uniform.wholeSphere, "uniform sky");
  check(std::fabs(uniform.luminance * Pi - Illuminance) <= 1e-12, "the ground gets pi L");
  CheckBounds(source, Position - glm::dvec3(0.75, 0.75, 0.0), Position + 0.75, check);

  source = Source(vtkLuminaireSource::CIE_SKY);
  const auto sky = Described<CieSky>(source, check);
  check(sky.up == up && sky.type == 12 && sky.horizontalIlluminance == Illuminance, "CIE sky");
  // 30 degrees above the east.
  check(glm::distance(sky.sun, glm::dvec3(std::sqrt(0.75), 0.0, 0.5)) <= 1e-15, "its sun");
  CheckBounds(source, Position - glm::dvec3(0.75, 0.75, 0.0), Position + 0.75, check);
}

std::string WriteIes()
{
  const auto path = std::filesystem::temp_directory_path() / "TestLuminaireSource.ies";
  std::ofstream(path) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n"
                      << "0 45 90\n0\n100 80 20\nEND\n";
  return path.string();
}

void CheckPhotometric(Checks& check)
{
  auto source = Source(vtkLuminaireSource::PHOTOMETRIC_FILE);
  const std::string path = WriteIes();
  source->SetFileName(path.c_str());
  const auto lamp = Described<PhotometricLamp>(source, check);
  check(lamp.position == Position && lamp.direction == Direction, "photometric lamp's place");
  check(std::fabs(lamp.rotation - 33.0 / 180.0 * Pi) <= AngleRounding, "its rotation");
  check(lamp.scale == 0.5, "dimming scales its intensities");
  check(lamp.solid.type == PhotometricSolid::Type::C, "its type");
  check(lamp.solid.polar == std::vector<double>{ 0.0, 45.0, 90.0 }, "its polar angles");
  check(lamp.solid.ratedFlux == 1000.0 && lamp.solid.inputPower == 50.0, "its lamps");
  const std::string note =
    "line 8: 'END' and what follows after the last candela value was not read";
  check(lamp.solid.notes == std::vector<std::string>{ note }, "what its reader assumed");
  check(FieldText(source->GetOutput(), "PhotometricNotes") == note + "\n", "as field data");
  const std::vector<double> row{ 100.0, 80.0, 20.0 };
  for (std::size_t i = 0; i < lamp.solid.candela.size(); ++i)
  {
    check(lamp.solid.candela[i] == row[i % 3], "its intensities");
  }
  // The diagram reaches from the lamp along its aim as far as the glyph is large. Beside it, it is
  // widest between 45 and 90 degrees, where it is 80 - 60 t high, at (1 + t) 45 degrees; a point of
  // its grid lies within half a step of 3 degrees of there in either angle.
  double widest = 0.0;
  for (double t = 0.0; t <= 1.0; t += 1e-4)
  {
    widest = std::max(widest, (0.8 - 0.6 * t) * std::sin((1.0 + t) * Pi / 4.0));
  }
  const double side = 0.75 * widest;
  CheckBounds(source, Position - glm::dvec3(0.0, side, side),
    Position + glm::dvec3(0.75, side, side), check, side * (1.0 - std::cos(Pi / 60.0)));
  std::filesystem::remove(path);
}

/// Large numbers overflow nowhere.
void CheckFarAway(Checks& check)
{
  const std::string path = WriteIes();
  for (int type = vtkLuminaireSource::PARALLEL; type <= vtkLuminaireSource::PHOTOMETRIC_FILE;
       ++type)
  {
    auto source = Source(type);
    source->SetPosition(1e200, -1e200, 0.0);
    source->SetDirection(1e-200, 1e-200, -1e-200);
    source->SetSize(1e30, 1e-30);
    source->SetGlyphSize(1e30);
    source->SetFileName(path.c_str());
    source->Update();
    vtkPolyData* output = source->GetOutput();
    check(output->GetNumberOfCells() > 0, "type " + std::to_string(type) + " is drawn far away");
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const double* point = output->GetPoint(p);
      check(std::isfinite(point[0] + point[1] + point[2]),
        "type " + std::to_string(type) + ": point " + std::to_string(p) + " is finite");
    }
  }
  std::filesystem::remove(path);
}

/// Expects one error with these words and nothing in the output.
void Expect(vtkLuminaireSource* source, const std::string& words, Checks& check)
{
  vtkNew<ErrorCounter> errors;
  const unsigned long tag = source->AddObserver(vtkCommand::ErrorEvent, errors);
  source->Update();
  source->RemoveObserver(tag);
  const std::string& error = errors->Messages;
  check(errors->Count == 1, "one error: " + words);
  check(error.find(words) != std::string::npos, "expected '" + words + "', not '" + error + "'");
  check(source->GetOutput()->GetNumberOfPoints() == 0 &&
      !source->GetOutput()->GetFieldData()->HasArray("LuminaireType"),
    "an empty output after: " + words);
  std::string refusal;
  try
  {
    ReadLuminaire(source->GetOutput());
  }
  catch (const InputError& again)
  {
    refusal = again.what();
  }
  check(refusal.find(words) != std::string::npos, "who reads it hears of: " + words);
}

void CheckErrors(Checks& check)
{
  const double nan = std::nan("");
  auto source = Source(vtkLuminaireSource::SPOT);
  source->SetPosition(0.0, nan, 0.0);
  Expect(source, "Position is (0, nan, 0); it must be finite", check);
  source = Source(vtkLuminaireSource::SPOT);
  source->SetDirection(0.0, 0.0, 0.0);
  Expect(source, "Direction is (0, 0, 0); it must be finite and not zero", check);
  source = Source(vtkLuminaireSource::SPOT);
  source->SetSpotHalfAngle(120.0);
  Expect(source, "SpotHalfAngle is 120; it must be at most 90 with a SpotExponent above 0", check);
  source->SetSpotExponent(0.0);
  source->SetSpotHalfAngle(0.0);
  Expect(source, "SpotHalfAngle is 0; it must be above 0 and at most 180", check);
  source->SetSpotHalfAngle(120.0);
  source->SetLuminousFlux(-1.0);
  Expect(source, "LuminousFlux is -1; it must be 0 or more", check);
  source->SetLuminousFlux(1e308);
  source->SetDimming(10.0);
  Expect(source, "LuminousFlux is 1e+308; it must be finite times Dimming, 10", check);
  source->SetDimming(nan);
  Expect(source, "Dimming is nan", check);
  source->SetDimming(1.0);
  source->SetLightColour(0.0, 0.0, 0.0);
  Expect(source, "LightColour is (0, 0, 0); it must be 0 or more, finite, and not all 0", check);
  source->SetLightColour(1.0, -1.0, 1.0);
  Expect(source, "LightColour is (1, -1, 1)", check);
  source->SetLightColour(1.0, 1.0, nan);
  Expect(source, "LightColour is (1, 1, nan)", check);
  source->SetLightColour(1.0, 1.0, 1.0);
  source->SetGlyphSize(0.0);
  Expect(source, "GlyphSize is 0", check);
  source->SetGlyphSize(1.0);
  source->Update();
  check(source->GetOutput()->GetNumberOfPoints() > 0, "after errors the source works");

  source = Source(vtkLuminaireSource::RECTANGLE);
  source->SetSize(1.0, -1.0);
  Expect(source, "Size[1] is -1; it must be within [0, 1e30]", check);
  source->SetType(vtkLuminaireSource::DISK); // which does not use it
  source->Update();
  check(source->GetOutput()->GetNumberOfPoints() > 0, "what a type does not use is not looked at");
  source = Source(vtkLuminaireSource::CIE_SKY);
  for (const int type : { 0, 17 })
  {
    source->SetSkyType(type);
    Expect(source, "SkyType is " + std::to_string(type) + "; it must be within 1 to 16", check);
  }
  source->SetSkyType(16);
  source->SetSunAltitude(-5.0);
  Expect(source, "SunAltitude is -5; it must be above 0 and at most 90", check);
  source->SetSunAltitude(5.0);
  source->SetIlluminance(nan);
  Expect(source, "Illuminance is nan", check);
  source = Source(vtkLuminaireSource::PHOTOMETRIC_FILE);
  Expect(source, "FileName is empty", check);
  source->SetFileName("no such file.ies");
  Expect(source, "no such file.ies", check);
}

} // namespace

int TestLuminaireSource(int, char*[])
{
  Checks check;
  CheckPoints(check);
  CheckAreas(check);
  CheckWithoutSize(check);
  CheckSkies(check);
  CheckPhotometric(check);
  CheckFarAway(check);
  CheckErrors(check);
  return check.Failures();
}
