// SPDX-License-Identifier: BSD-3-Clause
// Maps by luminaires that are connected one by one, in groups, moved, and from a photometric file.
// Fluxes are compared with closed forms.
#include "LuminaireTools.h"

#include "vtkIlluminationMap.h"

#include "vtkPhotometricReader.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkTransformFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkTrivialProducer.h"

#include <cmath>
#include <initializer_list>

namespace
{

const double Pi = std::acos(-1.0);
constexpr double Photons = 204800.0;

/// One metre by one, about the origin, with its front up.
vtkSmartPointer<vtkPolyData> Floor()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(8, 8);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

/// A floor and nothing else, under luminaires.
class Site
{
public:
  Site()
  {
    this->Filter->SetInputData(Floor());
    this->Filter->SetPhotons(static_cast<vtkIdType>(Photons));
    this->Filter->SetReflectance(0.0);
    this->Filter->SetLampContributions(true);
  }

  void Trace(std::initializer_list<vtkDataObject*> luminaires)
  {
    this->Filter->RemoveAllLuminaires();
    for (vtkDataObject* luminaire : luminaires)
    {
      vtkNew<vtkTrivialProducer> producer;
      producer->SetOutput(luminaire);
      this->Filter->AddLuminaireConnection(producer->GetOutputPort());
    }
    this->Messages->Clear();
    this->Filter->Update();
  }

  /// Flux on the floor, lm; -1 without such an array.
  double Flux(const char* array)
  {
    auto* map = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0));
    vtkDataArray* values = map ? PointArray(map, array) : nullptr;
    double flux = values ? 0.0 : -1.0;
    for (vtkIdType c = 0; values && c < map->GetNumberOfCells(); ++c)
    {
      vtkIdList* corners = map->GetCell(c)->GetPointIds();
      for (int i = 0; i < 3; ++i)
      {
        flux +=
          values->GetTuple1(corners->GetId(i)) / 3.0 / static_cast<double>(map->GetNumberOfCells());
      }
    }
    return flux;
  }

  /// Expects this share of a lamp's flux on the floor. A share p of N photons has the standard
  /// error sqrt(p (1 - p) / N), of random ones; N is the least that one of `lamps` even lamps gets.
  void ExpectShare(
    const char* array, double flux, double share, double lamps, const std::string& what)
  {
    const double error = std::sqrt(share * (1.0 - share) / (Photons / lamps));
    const double found = this->Flux(array) / flux;
    EXPECT_LE(std::fabs(found - share), 4.0 * error)
      << what << ": " << found << " of the flux for " << share;
  }

  void ExpectError(const std::string& words)
  {
    EXPECT_EQ(this->Messages->Errors, 1) << words;
    EXPECT_LT(this->Flux("Illuminance"), 0.0) << words;
    EXPECT_TRUE(Holds(this->Messages->Text, words));
  }

private:
  CaughtMessages Messages;
  vtkNew<vtkIlluminationMap> Filter;
};

/// The part of all directions that a square of side 1 fills, at this height above its middle.
double ShareOfPoint(double height)
{
  return std::atan(0.25 / (height * std::sqrt(0.5 + height * height))) / Pi;
}

/// View factor of two unit squares, parallel, one apart (Howell, catalog C-11).
double ShareOfSquare()
{
  return 2.0 / Pi *
    (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
      Pi / 2.0);
}

vtkSmartPointer<vtkPolyData> Lamp(int type, double flux, const char* name)
{
  auto source = Source(type);
  source->SetPosition(0.0, 0.0, 0.0);
  source->SetSize(0.5, 0.5);
  source->SetLuminousFlux(flux);
  source->SetLuminaireName(name);
  source->Update();
  return source->GetOutput();
}

/// A point lamp half a metre above the floor's middle.
vtkSmartPointer<vtkPolyData> Point(const char* name = "Point")
{
  return Transformed(Lamp(vtkLuminaireSource::POINT, 300.0, name),
    [](vtkTransform* t) { t->Translate(0.0, 0.0, 0.5); });
}

/// A square of one metre a metre above the floor, which was one of half a metre and shone along x.
vtkSmartPointer<vtkPolyData> Square()
{
  auto source = Source(vtkLuminaireSource::RECTANGLE);
  source->SetPosition(5.0, 0.0, 0.0);
  source->SetDirection(1.0, 0.0, 0.0);
  source->SetSize(0.5, 0.5);
  source->SetLuminousFlux(700.0);
  source->SetLuminaireName("Square");
  source->Update();
  return Transformed(source->GetOutput(),
    [](vtkTransform* t)
    {
      t->Translate(0.0, 0.0, 1.0); // each acts before those above it
      t->RotateY(90.0);
      t->Scale(2.0, 2.0, 2.0);
      t->Translate(-5.0, 0.0, 0.0);
    });
}

/// A panel with an exitance of 100 lm/m^2, in place of the square.
vtkSmartPointer<vtkPolyData> Panel()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetCenter(0.0, 0.0, 1.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  plane->Update();
  vtkNew<vtkFloatArray> exitance;
  exitance->SetName("Exitance");
  exitance->InsertNextValue(100.0f);
  plane->GetOutput()->GetCellData()->AddArray(exitance);
  return plane->GetOutput();
}

void ExpectBoth(Site& site, const std::string& how)
{
  // Each lamp's photons are as many as its share of the flux.
  site.ExpectShare("Illuminance_Point", 300.0, ShareOfPoint(0.5), 1000.0 / 300.0, how + ": point");
  site.ExpectShare("Illuminance_Square", 700.0, ShareOfSquare(), 1000.0 / 700.0, how + ": square");
  site.ExpectShare(
    "Illuminance", 1000.0, 0.3 * ShareOfPoint(0.5) + 0.7 * ShareOfSquare(), 1.0, how);
}

/// Names of the arrays of lamps with these names.
void CheckNames(
  Site& site, const std::vector<const char*>& given, const std::vector<const char*>& expected)
{
  vtkNew<vtkMultiBlockDataSet> group;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    group->SetBlock(static_cast<unsigned>(i), Point(given[i]));
  }
  site.Trace({ group });
  for (const char* name : expected)
  {
    const std::string array = std::string("Illuminance_") + name;
    EXPECT_GT(site.Flux(array.c_str()), 0.0) << "there is an array " << array;
  }
}

} // namespace

TEST(LuminaireGroups, MovedLampsLightTheFloor)
{
  Site site;
  site.Trace({ Point() });
  site.ExpectShare("Illuminance", 300.0, ShareOfPoint(0.5), 1.0, "a point lamp that was moved");
  site.Trace({ Square() });
  site.ExpectShare("Illuminance", 700.0, ShareOfSquare(), 1.0, "a panel, turned and enlarged");
  const auto noSize = Source(vtkLuminaireSource::SPHERE);
  noSize->SetPosition(0.0, 0.0, 0.5);
  noSize->SetSize(0.0, 0.0);
  noSize->Update();
  site.Trace({ noSize->GetOutput() });
  site.ExpectShare("Illuminance", 1000.0, ShareOfPoint(0.5), 1.0, "a ball without a size");
}

TEST(LuminaireGroups, LampsInGroupsLightTheFloor)
{
  Site site;
  site.Trace({ Point(), Square() });
  ExpectBoth(site, "one by one");

  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, Point());
  group->SetBlock(2, Square());
  site.Trace({ group });
  ExpectBoth(site, "in a group with a block that is missing");

  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, vtkSmartPointer<vtkPolyData>::New());
  inner->SetBlock(1, Square());
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, Point());
  outer->SetBlock(1, inner);
  site.Trace({ outer });
  ExpectBoth(site, "nested, with an empty block");
  site.Trace({ Point(), inner });
  ExpectBoth(site, "a group beside a single lamp");

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, Point());
  collection->SetPartition(1, 0, Square());
  site.Trace({ collection });
  ExpectBoth(site, "in a collection");
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Point());
  parts->SetPartition(1, Square());
  site.Trace({ parts });
  ExpectBoth(site, "in partitions");

  vtkNew<vtkMultiBlockDataSet> surfaces;
  surfaces->SetBlock(0, Panel());
  surfaces->SetBlock(1, Panel());
  site.Trace({ surfaces });
  site.ExpectShare("Illuminance", 200.0, ShareOfSquare(), 1.0, "surfaces that shine");
}

// A filter for single data sets in between works on each block.
TEST(LuminaireGroups, MovedGroupsLightTheFloor)
{
  Site site;
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, Lamp(vtkLuminaireSource::POINT, 500.0, "A"));
  group->SetBlock(1, Lamp(vtkLuminaireSource::SPHERE, 500.0, "B"));
  vtkNew<vtkTransform> up;
  up->Translate(0.0, 0.0, 0.5);
  vtkNew<vtkTransformFilter> transform;
  transform->SetInputData(group);
  transform->SetTransform(up);
  transform->Update();
  site.Trace({ transform->GetOutputDataObject(0) });
  site.ExpectShare("Illuminance_A", 500.0, ShareOfPoint(0.5), 2.0, "a group that was moved");
}

TEST(LuminaireGroups, PhotometricFilesLightTheFloor)
{
  Site site;
  vtkNew<vtkPhotometricReader> reader;
  reader->SetFileName(PhotometricFile("isotropic.ies").c_str());
  reader->Update();
  const double flux = FieldValue(reader->GetOutput(), "LuminaireFlux");
  EXPECT_GT(flux, 1000.0) << "the file's flux";
  const auto up = [](vtkTransform* t) { t->Translate(0.0, 0.0, 0.5); };
  site.Trace({ Transformed(reader->GetOutput(), up) });
  site.ExpectShare("Illuminance_isotropic", flux, ShareOfPoint(0.5), 1.0, "an isotropic file");

  // I0 cos, as a small flat lamp: the share of a square half a metre below is
  // 4 F(1, 1) (Howell, catalog B-4, with both sides as long as the height).
  reader->SetFileName(PhotometricFile("lambertian.ies").c_str());
  reader->Update();
  const double share = 4.0 / (2.0 * Pi) * 2.0 / std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0));
  site.Trace({ Transformed(reader->GetOutput(), up) });
  const double total = FieldValue(reader->GetOutput(), "LuminaireFlux");
  site.ExpectShare("Illuminance", total, share, 1.0, "a Lambertian file that aims down");
  site.Trace({ Transformed(reader->GetOutput(),
    [&](vtkTransform* t)
    {
      up(t);
      t->RotateX(180.0);
    }) });
  EXPECT_EQ(site.Flux("Illuminance"), 0.0) << "turned over, it shines away from the floor";
}

TEST(LuminaireGroups, WhatIsNoLuminaireIsRefused)
{
  Site site;
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, Point());
  group->SetBlock(1, Floor());
  group->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "Desk");
  site.Trace({ group });
  site.ExpectError("luminaire 1, block 2 'Desk' is none: it has neither");
  group->SetBlock(1, vtkSmartPointer<vtkImageData>::New());
  site.Trace({ Square(), group });
  site.ExpectError("luminaire 2, block 2 'Desk' is none: it is a vtkImageData");
  site.Trace({ vtkSmartPointer<vtkImageData>::New() });
  site.ExpectError("luminaire 1 is none: it is a vtkImageData");
  site.Trace({ vtkSmartPointer<vtkMultiBlockDataSet>::New() });
  site.ExpectError("luminaire 1 is a group without any luminaire in it");
  site.Trace({ vtkSmartPointer<vtkPolyData>::New() });
  site.ExpectError("luminaire 1 is none");

  auto broken = Source(vtkLuminaireSource::PHOTOMETRIC_FILE);
  broken->Update();
  group->SetBlock(1, broken->GetOutput());
  site.Trace({ group });
  site.ExpectError("block 2 'Desk': its source has an error: FileName is empty");

  const auto both = Panel();
  both->GetFieldData()->PassData(Lamp(vtkLuminaireSource::POINT, 1.0, "")->GetFieldData());
  site.Trace({ both });
  site.ExpectError("both the field data of a luminaire and a cell array 'Exitance'");
}

// A lamp that is connected as a part of the scene is a surface, and a note says so.
TEST(LuminaireGroups, LampAmongTheSurfacesIsNoted)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, Floor());
  scene->SetBlock(1, Lamp(vtkLuminaireSource::DISK, 1000.0, ""));
  vtkNew<vtkIlluminationMap> filter;
  filter->SetInputData(scene);
  filter->SetPhotons(2048);
  filter->Update();
  const std::string notes = FieldText(filter->GetOutputDataObject(0), "Notes");
  EXPECT_TRUE(Holds(notes, "the surface of block 2 is, or was appended to, a luminaire"));
  EXPECT_FALSE(Holds(notes, "the surface of block 1 is"));
}

TEST(LuminaireGroups, ArraysHaveTheNamesOfLamps)
{
  Site site;
  CheckNames(site, { "Lamp 2", "" }, { "Lamp 2", "Lamp 2 (2)" });
  CheckNames(site, { "", " ", "" }, { "Lamp 1", "Lamp 2", "Lamp 3" });
  CheckNames(site, { "A", "A", "A (2)", "A" }, { "A", "A (2)", "A (3)", "A (4)" });
  CheckNames(site, { "", "Lamp 1", "Lamp 1 (2)" }, { "Lamp 1", "Lamp 1 (2)", "Lamp 1 (3)" });
}
