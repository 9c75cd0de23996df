// SPDX-License-Identifier: BSD-3-Clause
// The reader of photometric files: the surface it draws, field data, errors.
#include "Messages.h"
#include "OutputData.h"

#include "vtkPhotometricReader.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <cmath>

namespace
{

constexpr double Pi = 3.14159265358979323846;

std::string DataFile(const std::string& name)
{
  return std::string(ILLUMINATION_TEST_DATA) + "/photometry/" + name;
}

vtkSmartPointer<vtkPolyData> Read(const std::string& name, double size = 1.0)
{
  vtkNew<vtkPhotometricReader> reader;
  reader->SetFileName(DataFile(name).c_str());
  reader->SetSize(size);
  reader->Update();
  return reader->GetOutput();
}

bool Near(double value, double expected, double error)
{
  return std::abs(value - expected) <= error;
}

/// By the divergence theorem, positive if facets look outwards.
double Volume(vtkPolyData* surface)
{
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    double a[3], b[3], c[3];
    surface->GetPoint(corners->GetId(0), a);
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
    {
      surface->GetPoint(corners->GetId(i - 1), b);
      surface->GetPoint(corners->GetId(i), c);
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6.0;
    }
  }
  return volume;
}

void CheckClosed(vtkPolyData* surface, const std::string& name)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_GT(surface->GetNumberOfCells(), 100) << name << " has facets";
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << name << " is closed";
  EXPECT_GT(Volume(surface), 0.0) << name << " looks outwards";
}

/// Steps of 3 degrees and interpolation within the file's steps both lose at most the square of the
/// step / 8 of a radius (and a 1e-5th by the file's digits).
double SquaredStep(double degrees)
{
  return std::pow(degrees * Pi / 180.0, 2) / 8.0 + 1e-5;
}

} // namespace

TEST(PhotometricReader, DrawsClosedSurfaces)
{
  for (const char* name : { "isotropic.ies", "isotropic.ldt", "lambertian.ies", "lateral.ldt",
         "tilt_file.ies", "spots.ies" })
  {
    CheckClosed(Read(name), name);
  }
}

TEST(PhotometricReader, DrawsIntensityAsDistance)
{
  const auto even = Read("isotropic.ies", 2.0);
  // A facet's deepest point lies a step's square / 8 below the sphere in either direction.
  const double ball = 4.0 / 3.0 * Pi * 8.0;
  const double volume = Volume(even);
  EXPECT_TRUE(volume < ball && volume > ball * (1.0 - 3.0 * 2.0 * SquaredStep(3.0)))
    << "even light, a ball";
  const auto lambertian = Read("lambertian.ies");
  for (vtkIdType p = 0; p < lambertian->GetNumberOfPoints(); ++p)
  {
    double x[3];
    lambertian->GetPoint(p, x);
    // r = cos p is a ball about (0, 0, -1/2).
    const double radius = std::hypot(std::hypot(x[0], x[1]), x[2] + 0.5);
    EXPECT_TRUE(Near(radius, 0.5, SquaredStep(5.0))) << "Lambertian light, a ball below the origin";
    const double candela = PointArray(lambertian, "LuminousIntensity")->GetTuple1(p);
    EXPECT_TRUE(Near(candela, 1900.0 * std::hypot(std::hypot(x[0], x[1]), x[2]), 1e-9))
      << "distance is in proportion to intensity";
  }
}

TEST(PhotometricReader, DrawsDirectionsAsTheyAre)
{
  for (const char* name :
    { "asymmetric_c.ies", "asymmetric_b.ies", "asymmetric_a.ies", "asymmetric.ldt" })
  {
    const auto surface = Read(name);
    CheckClosed(surface, name);
    double bounds[6];
    surface->GetBounds(bounds);
    const std::string what = name;
    EXPECT_GT(bounds[1], 1.5 * -bounds[0]) << what << " is brighter to +x";
    EXPECT_GT(bounds[3], 1.2 * -bounds[2]) << what << " is brighter to +y";
    EXPECT_GT(bounds[1], 1.1 * bounds[3]) << what << " is brightest to +x";
    EXPECT_TRUE(bounds[5] < 1e-9 && bounds[4] < -0.8) << what << " shines down";
  }
}

TEST(PhotometricReader, DescribesTheLuminaire)
{
  const auto lambertian = Read("lambertian.ies");
  const double flux = FieldValue(lambertian, "LuminaireFlux");
  EXPECT_TRUE(Near(flux, 1900.0 * Pi, 1900.0 * 2.0 * Pi * SquaredStep(5.0)))
    << "flux of the luminaire";
  EXPECT_EQ(FieldValue(lambertian, "RatedFlux"), 7000.0) << "flux of the lamps";
  EXPECT_EQ(FieldValue(lambertian, "InputPower"), 70.0) << "power";
  EXPECT_EQ(FieldValue(lambertian, "Efficacy"), flux / 70.0) << "efficacy";
  EXPECT_EQ(FieldText(lambertian, "Description"), "Example, Lambertian panel, COS-1\n")
    << "description";
  EXPECT_EQ(FieldText(lambertian, "PhotometricType"), "C\n") << "type C";
  EXPECT_TRUE(
    lambertian->GetFieldData()->GetAbstractArray("Notes") && FieldText(lambertian, "Notes").empty())
    << "no notes on a file by the standard";
  EXPECT_TRUE(
    Holds(FieldText(Read("tilt_file.ies"), "Notes"), "no line tells the edition of LM-63"))
    << "a note on a file that is not clear";
  EXPECT_EQ(FieldText(Read("asymmetric_b.ies"), "PhotometricType"), "B\n") << "type B";
  EXPECT_EQ(FieldText(Read("asymmetric_a.ies"), "PhotometricType"), "A\n") << "type A";
}

TEST(PhotometricReader, FilesThatCannotBeReadAreRefused)
{
  vtkNew<vtkPhotometricReader> reader;
  const auto expect = [&](const std::string& message)
  {
    const std::string error = ErrorOf(reader);
    EXPECT_TRUE(Holds(error, message));
    EXPECT_EQ(message.empty(), error.empty()) << error;
    EXPECT_EQ(message.empty(), reader->GetOutput()->GetNumberOfPoints() > 0)
      << "no output on errors";
  };
  expect("FileName is empty");
  reader->SetFileName(DataFile("tilt.tlt").c_str());
  expect("has none of the extensions .ies, .ldt and .eul");
  EXPECT_FALSE(reader->CanReadFile(reader->GetFileName())) << "can't read another kind";
  reader->SetFileName(DataFile("absent.ies").c_str());
  expect("can't open the photometric file '" + DataFile("absent.ies"));
  EXPECT_FALSE(reader->CanReadFile(reader->GetFileName())) << "can't read what is not there";
  reader->SetFileName(DataFile("broken.ies").c_str());
  expect("broken.ies', line 6: vertical angle 3 is '4O'; it must be a number");
  EXPECT_TRUE(reader->CanReadFile(reader->GetFileName())) << "by its name it can be read";
  reader->SetFileName(DataFile("isotropic.ldt").c_str());
  reader->SetSize(0.0);
  expect("Size is 0; it must be a finite number above 0");
  reader->SetSize(1.0);
  expect("");
  EXPECT_FALSE(reader->CanReadFile(nullptr)) << "no name";
}
