// SPDX-License-Identifier: BSD-3-Clause
// The luminaire source: each type's description comes back out of the field data with all its
// values, its geometry is where and as large as it should be, and bad values give one error.
#include "Messages.h"
#include "OutputData.h"

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

using namespace Illumination;

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
constexpr double FluxBeforeDimming = 800.0;
constexpr double IlluminanceBeforeDimming = 600.0;

/// The lamp as the field data describe it; all values 0 if they describe another type.
template <typename Lamp>
Lamp Described(vtkLuminaireSource* source)
{
  source->Update();
  const auto luminaire = ReadLuminaire(source->GetOutput());
  const std::string type = "type " + std::to_string(source->GetType());
  EXPECT_TRUE(luminaire && std::holds_alternative<Lamp>(luminaire->lamp)) << type << " comes back";
  EXPECT_TRUE(luminaire && luminaire->name == "over the desk") << type << " keeps its name";
  EXPECT_TRUE(luminaire && luminaire->colour == Colour(0.5f, 1.0f, 0.25f))
    << type << " keeps its colour";
  EXPECT_TRUE(luminaire && luminaire->dimming == 0.5) << type << " keeps its dimming";
  const Lamp* lamp = luminaire ? std::get_if<Lamp>(&luminaire->lamp) : nullptr;
  return lamp ? *lamp : Lamp{};
}

/// The geometry's bounds; a polyhedron's round sides may lie `inside` the sphere or circle.
void CheckBounds(
  vtkLuminaireSource* source, const glm::dvec3& low, const glm::dvec3& high, double inside = 0.0)
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
      EXPECT_TRUE(gap >= -rounding && gap <= inside + rounding)
        << "type " << source->GetType() << ": bounds of axis " << axis << " are off by " << gap;
    }
  }
}

/// Whether the first polygon faces the side to which the panel shines.
bool FacesItsLight(vtkPolyData* panel)
{
  double normal[3];
  vtkCell* cell = panel->GetCell(panel->GetNumberOfLines());
  vtkPolygon::ComputeNormal(cell->GetPoints(), normal);
  return normal[0] > 0.999;
}

/// A file for the test that runs; others may run beside it.
std::string WriteIes()
{
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = std::filesystem::temp_directory_path() / (test + ".ies");
  std::ofstream(path) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n"
                      << "0 45 90\n0\n100 80 20\nEND\n";
  return path.string();
}

/// Expects one error with these words and nothing in the output.
void Expect(vtkLuminaireSource* source, const std::string& words)
{
  EXPECT_TRUE(Holds(ErrorOf(source), words));
  EXPECT_TRUE(source->GetOutput()->GetNumberOfPoints() == 0 &&
    !source->GetOutput()->GetFieldData()->HasArray("LuminaireType"))
    << "an empty output after: " << words;
  std::string refusal;
  try
  {
    ReadLuminaire(source->GetOutput());
  }
  catch (const InputError& again)
  {
    refusal = again.what();
  }
  EXPECT_TRUE(Holds(refusal, words)) << "who reads it hears of: " << words;
}

} // namespace

TEST(LuminaireSource, PointLikeLampsComeBack)
{
  auto source = Source(vtkLuminaireSource::PARALLEL);
  const auto parallel = Described<ParallelLight>(source);
  EXPECT_TRUE(parallel.direction == Direction && parallel.illuminance == IlluminanceBeforeDimming)
    << "parallel light";
  const double tip = 0.1 * 0.75; // vtkArrowSource's radius
  CheckBounds(source, Position - glm::dvec3(0.0, tip, tip), Position + glm::dvec3(0.75, tip, tip),
    tip * (1.0 - std::cos(Pi / 48.0)));

  source = Source(vtkLuminaireSource::POINT);
  const auto point = Described<PointLamp>(source);
  EXPECT_TRUE(point.position == Position && point.flux == FluxBeforeDimming) << "point lamp";
  CheckBounds(source, Position - 0.375, Position + 0.375);

  source = Source(vtkLuminaireSource::LAMBERTIAN_POINT);
  const auto flat = Described<LambertianPointLamp>(source);
  EXPECT_TRUE(
    flat.position == Position && flat.direction == Direction && flat.flux == FluxBeforeDimming)
    << "flat lamp";
  CheckBounds(source, Position - glm::dvec3(0.0, tip, tip), Position + glm::dvec3(0.75, tip, tip),
    tip * (1.0 - std::cos(Pi / 48.0)));

  source = Source(vtkLuminaireSource::SPOT);
  const auto spot = Described<SpotLamp>(source);
  EXPECT_TRUE(
    spot.position == Position && spot.direction == Direction && spot.flux == FluxBeforeDimming)
    << "spot";
  EXPECT_LE(std::fabs(spot.halfAngle - Pi / 3.0), AngleRounding * Pi / 3.0) << "spot's angle";
  EXPECT_EQ(spot.exponent, 1.5) << "spot's exponent";
  const double radius = 0.75 * std::sqrt(0.75);
  CheckBounds(source, Position - glm::dvec3(0.0, radius, radius),
    Position + glm::dvec3(0.75, radius, radius), radius * (1.0 - std::cos(Pi / 48.0)));
}

TEST(LuminaireSource, LampsWithAnAreaComeBack)
{
  auto source = Source(vtkLuminaireSource::RECTANGLE);
  const auto rectangle = Described<RectangleLamp>(source);
  EXPECT_TRUE(rectangle.centre == Position && rectangle.direction == Direction)
    << "rectangle's place";
  EXPECT_TRUE(
    rectangle.width == 0.5 && rectangle.height == 0.25 && rectangle.flux == FluxBeforeDimming)
    << "rectangle";
  // The width along z x direction = y; a line along the light, half as long as the mean side.
  CheckBounds(
    source, Position - glm::dvec3(0.0, 0.25, 0.125), Position + glm::dvec3(0.1875, 0.25, 0.125));
  EXPECT_TRUE(FacesItsLight(source->GetOutput())) << "the rectangle faces its light";
  source->SetDirection(0.0, 0.0, -1.0);
  source->Update();
  CheckBounds(
    source, Position - glm::dvec3(0.25, 0.125, 0.1875), Position + glm::dvec3(0.25, 0.125, 0.0));

  source = Source(vtkLuminaireSource::DISK);
  const auto disk = Described<DiskLamp>(source);
  EXPECT_TRUE(disk.centre == Position && disk.direction == Direction) << "disk's place";
  EXPECT_TRUE(disk.radius == 0.5 && disk.flux == FluxBeforeDimming) << "disk";
  CheckBounds(source, Position - glm::dvec3(0.0, 0.5, 0.5), Position + glm::dvec3(0.5, 0.5, 0.5),
    0.5 * (1.0 - std::cos(Pi / 48.0)));
  EXPECT_TRUE(FacesItsLight(source->GetOutput())) << "the disk faces its light";

  source = Source(vtkLuminaireSource::SPHERE);
  const auto sphere = Described<SphereLamp>(source);
  EXPECT_TRUE(sphere.centre == Position && sphere.radius == 0.5 && sphere.flux == FluxBeforeDimming)
    << "sphere";
  CheckBounds(source, Position - 0.5, Position + 0.5);

  source = Source(vtkLuminaireSource::LINE);
  const auto line = Described<LineLamp>(source);
  EXPECT_TRUE(line.centre == Position && line.axis == Direction) << "line's place";
  EXPECT_TRUE(line.length == 0.5 && line.flux == FluxBeforeDimming) << "line";
  CheckBounds(source, Position - glm::dvec3(0.25, 0.0, 0.0), Position + glm::dvec3(0.25, 0.0, 0.0));
}

// All light from one point: drawn as point-like lamps are.
TEST(LuminaireSource, LampsWithoutASizeAreDrawn)
{
  for (const int type : { vtkLuminaireSource::RECTANGLE, vtkLuminaireSource::DISK,
         vtkLuminaireSource::SPHERE, vtkLuminaireSource::LINE })
  {
    auto source = Source(type);
    source->SetSize(0.0, 0.0);
    source->Update();
    double bounds[6];
    source->GetOutput()->GetBounds(bounds);
    EXPECT_LT(std::fabs(bounds[1] - bounds[0] - 0.75), 1e-6)
      << "type " << type << " without a size is as long as its glyph";
    EXPECT_TRUE(ReadLuminaire(source->GetOutput()).has_value()) << "and is a lamp";
  }
}

TEST(LuminaireSource, SkiesComeBack)
{
  const glm::dvec3 up(0.0, 0.0, 1.0);
  auto source = Source(vtkLuminaireSource::UNIFORM_SKY);
  const auto uniform = Described<UniformSky>(source);
  EXPECT_TRUE(uniform.up == up && !uniform.wholeSphere) << "uniform sky";
  EXPECT_LE(std::fabs(uniform.luminance * Pi - IlluminanceBeforeDimming), 1e-12)
    << "the ground gets pi L";
  CheckBounds(source, Position - glm::dvec3(0.75, 0.75, 0.0), Position + 0.75);

  source = Source(vtkLuminaireSource::CIE_SKY);
  const auto sky = Described<CieSky>(source);
  EXPECT_TRUE(
    sky.up == up && sky.type == 12 && sky.horizontalIlluminance == IlluminanceBeforeDimming)
    << "CIE sky";
  // 30 degrees above the east.
  EXPECT_LE(glm::distance(sky.sun, glm::dvec3(std::sqrt(0.75), 0.0, 0.5)), 1e-15) << "its sun";
  CheckBounds(source, Position - glm::dvec3(0.75, 0.75, 0.0), Position + 0.75);
}

TEST(LuminaireSource, PhotometricFileComesBack)
{
  auto source = Source(vtkLuminaireSource::PHOTOMETRIC_FILE);
  const std::string path = WriteIes();
  source->SetFileName(path.c_str());
  const auto lamp = Described<PhotometricLamp>(source);
  EXPECT_TRUE(lamp.position == Position && lamp.direction == Direction)
    << "photometric lamp's place";
  EXPECT_LE(std::fabs(lamp.rotation - 33.0 / 180.0 * Pi), AngleRounding) << "its rotation";
  EXPECT_EQ(lamp.scale, 1.0) << "dimming is told apart";
  EXPECT_EQ(lamp.solid.type, PhotometricSolid::Type::C) << "its type";
  EXPECT_EQ(lamp.solid.polar, (std::vector<double>{ 0.0, 45.0, 90.0 })) << "its polar angles";
  EXPECT_TRUE(lamp.solid.ratedFlux == 1000.0 && lamp.solid.inputPower == 50.0) << "its lamps";
  const std::string note =
    "line 8: 'END' and what follows after the last candela value was not read";
  EXPECT_EQ(lamp.solid.notes, (std::vector<std::string>{ note })) << "what its reader assumed";
  EXPECT_EQ(FieldText(source->GetOutput(), "PhotometricNotes"), note + "\n") << "as field data";
  const std::vector<double> row{ 100.0, 80.0, 20.0 };
  for (std::size_t i = 0; i < lamp.solid.candela.size(); ++i)
  {
    EXPECT_EQ(lamp.solid.candela[i], row[i % 3]) << "its intensities";
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
    Position + glm::dvec3(0.75, side, side), side * (1.0 - std::cos(Pi / 60.0)));
  std::filesystem::remove(path);
}

// Large numbers overflow nowhere.
TEST(LuminaireSource, FarAwayIsFinite)
{
  const std::string path = WriteIes();
  for (int type = vtkLuminaireSource::PARALLEL; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    auto source = Source(type);
    source->SetPosition(1e200, -1e200, 0.0);
    source->SetDirection(1e-200, 1e-200, -1e-200);
    source->SetSize(1e30, 1e-30);
    source->SetGlyphSize(1e30);
    source->SetFileName(path.c_str());
    source->Update();
    vtkPolyData* output = source->GetOutput();
    EXPECT_GT(output->GetNumberOfCells(), 0) << "type " << type << " is drawn far away";
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const double* point = output->GetPoint(p);
      EXPECT_TRUE(std::isfinite(point[0] + point[1] + point[2]))
        << "type " << type << ": point " << p << " is finite";
    }
  }
  std::filesystem::remove(path);
}

TEST(LuminaireSource, SettingsOutOfRangeAreRefused)
{
  const double nan = std::nan("");
  auto source = Source(vtkLuminaireSource::SPOT);
  source->SetPosition(0.0, nan, 0.0);
  Expect(source, "Position is (0, nan, 0); it must be finite");
  source = Source(vtkLuminaireSource::SPOT);
  source->SetDirection(0.0, 0.0, 0.0);
  Expect(source, "Direction is (0, 0, 0); it must be finite and not zero");
  source = Source(vtkLuminaireSource::SPOT);
  source->SetSpotHalfAngle(120.0);
  Expect(source, "SpotHalfAngle is 120; it must be at most 90 with a SpotExponent above 0");
  source->SetSpotExponent(0.0);
  source->SetSpotHalfAngle(0.0);
  Expect(source, "SpotHalfAngle is 0; it must be above 0 and at most 180");
  source->SetSpotHalfAngle(120.0);
  source->SetLuminousFlux(-1.0);
  Expect(source, "LuminousFlux is -1; it must be 0 or more");
  source->SetLuminousFlux(1e308);
  source->SetDimming(10.0);
  Expect(source, "LuminousFlux is 1e+308; it must be finite times Dimming, 10");
  source->SetDimming(nan);
  Expect(source, "Dimming is nan");
  source->SetDimming(1.0);
  source->SetLightColour(0.0, 0.0, 0.0);
  Expect(source, "LightColour is (0, 0, 0); it must be 0 or more, finite, and not all 0");
  source->SetLightColour(1.0, -1.0, 1.0);
  Expect(source, "LightColour is (1, -1, 1)");
  source->SetLightColour(1.0, 1.0, nan);
  Expect(source, "LightColour is (1, 1, nan)");
  source->SetLightColour(1.0, 1.0, 1.0);
  source->SetGlyphSize(0.0);
  Expect(source, "GlyphSize is 0");
  source->SetGlyphSize(1.0);
  source->Update();
  EXPECT_GT(source->GetOutput()->GetNumberOfPoints(), 0) << "after errors the source works";

  source = Source(vtkLuminaireSource::RECTANGLE);
  source->SetSize(1.0, -1.0);
  Expect(source, "Size[1] is -1; it must be within [0, 1e30]");
  source->SetType(vtkLuminaireSource::DISK); // which does not use it
  source->Update();
  EXPECT_GT(source->GetOutput()->GetNumberOfPoints(), 0)
    << "what a type does not use is not looked at";
  source = Source(vtkLuminaireSource::CIE_SKY);
  for (const int type : { 0, 17 })
  {
    source->SetSkyType(type);
    Expect(source, "SkyType is " + std::to_string(type) + "; it must be within 1 to 16");
  }
  source->SetSkyType(16);
  source->SetSunAltitude(-5.0);
  Expect(source, "SunAltitude is -5; it must be above 0 and at most 90");
  source->SetSunAltitude(5.0);
  source->SetIlluminance(nan);
  Expect(source, "Illuminance is nan");
  source = Source(vtkLuminaireSource::PHOTOMETRIC_FILE);
  Expect(source, "FileName is empty");
  source->SetFileName("no such file.ies");
  Expect(source, "no such file.ies");
}
