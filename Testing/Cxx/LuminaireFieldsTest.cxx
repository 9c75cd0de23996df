// SPDX-License-Identifier: BSD-3-Clause
// Luminaires as field data and as emitting surfaces: what comes back, and what is refused.
#include "LuminaireTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace PhotonTransport;

PhotometricLamp SolidOfTypeB()
{
  PhotometricLamp lamp;
  lamp.solid.type = PhotometricSolid::Type::B;
  lamp.solid.polar = { 10.0, 90.0, 170.0 };
  lamp.solid.azimuth = { -90.0, 90.0 };
  lamp.solid.candela = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 };
  lamp.solid.ratedFlux = 7.0;
  lamp.solid.inputPower = 8.0;
  lamp.solid.width = 0.1;
  lamp.solid.length = 0.2;
  lamp.solid.height = 0.3;
  lamp.solid.description = "a floodlight";
  lamp.solid.notes = { "line 1: assumed", "line 2: odd" };
  return lamp;
}

vtkSmartPointer<vtkPolyData> Carrier(const Luminaire& luminaire)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  AddLuminaire(data->GetFieldData(), luminaire);
  return data;
}

void SetNumbers(vtkPolyData* data, const char* name, const std::vector<double>& numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double number : numbers)
  {
    array->InsertNextValue(number);
  }
  data->GetFieldData()->AddArray(array);
}

void SetText(vtkPolyData* data, const char* name, const char* text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

/// A square of area 4 that faces +z and a triangle strip of area 4 to its right, which faces +z
/// too.
vtkSmartPointer<vtkPolyData> Panels(int components)
{
  vtkNew<vtkPoints> points;
  for (const double x : { 0.0, 2.0, 4.0 })
  {
    points->InsertNextPoint(x, 0.0, 0.0);
    points->InsertNextPoint(x, 2.0, 0.0);
  }
  vtkNew<vtkCellArray> polys;
  const vtkIdType square[4] = { 0, 2, 3, 1 };
  polys->InsertNextCell(4, square);
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[4] = { 2, 4, 3, 5 };
  strips->InsertNextCell(4, strip);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polys);
  data->SetStrips(strips);
  vtkNew<vtkFloatArray> exitance;
  exitance->SetName("Exitance");
  exitance->SetNumberOfComponents(components);
  exitance->SetNumberOfTuples(2);
  exitance->Fill(100.0);
  data->GetCellData()->AddArray(exitance);
  return data;
}

glm::dvec3 Normal(const EmittingMesh& mesh, std::size_t facet)
{
  const glm::uvec3 f = mesh.facets[facet];
  return glm::cross(mesh.points[f.y] - mesh.points[f.x], mesh.points[f.z] - mesh.points[f.x]);
}

void CheckMesh(const Luminaire& luminaire, double z, float first, float second)
{
  const auto* mesh = std::get_if<EmittingMesh>(&luminaire.lamp);
  EXPECT_TRUE(mesh && mesh->facets.size() == 4)
    << "two triangles of the square and two of the strip";
  for (std::size_t f = 0; mesh && f < mesh->facets.size(); ++f)
  {
    EXPECT_EQ(Normal(*mesh, f), glm::dvec3(0.0, 0.0, z * 4.0)) << "facets face their light";
    const glm::uvec3 corners = mesh->facets[f];
    const bool ofSquare = std::max({ mesh->points[corners.x].x, mesh->points[corners.y].x,
                            mesh->points[corners.z].x }) == 2.0;
    EXPECT_EQ(mesh->exitance[f], ofSquare ? first : second) << "each facet has its cell's exitance";
  }
}

} // namespace

TEST(LuminaireFields, PhotometricSolidComesBack)
{
  const PhotometricSolid given = SolidOfTypeB().solid;
  // Through a file too, whose format has its own way with texts.
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  AddLuminaire(plane->GetOutput()->GetFieldData(), { SolidOfTypeB(), "" });
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(plane->GetOutput());
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  const auto luminaire = ReadLuminaire(reader->GetOutput());
  const auto* lamp = luminaire ? std::get_if<PhotometricLamp>(&luminaire->lamp) : nullptr;
  EXPECT_TRUE(lamp && luminaire->name.empty()) << "a photometric lamp without a name comes back";
  if (!lamp)
  {
    return;
  }
  const PhotometricSolid& solid = lamp->solid;
  EXPECT_EQ(solid.type, given.type) << "type";
  EXPECT_TRUE(solid.polar == given.polar && solid.azimuth == given.azimuth) << "angles";
  EXPECT_EQ(solid.candela, given.candela) << "intensities";
  EXPECT_TRUE(solid.ratedFlux == 7.0 && solid.inputPower == 8.0) << "flux and power";
  EXPECT_TRUE(solid.width == 0.1 && solid.length == 0.2 && solid.height == 0.3) << "opening";
  EXPECT_EQ(solid.description, given.description) << "description";
  EXPECT_EQ(solid.notes, given.notes) << "notes";

  UniformSky sky;
  sky.wholeSphere = true;
  sky.up = { 0.0, 1.0, 0.0 };
  const auto round = ReadLuminaire(Carrier({ sky, "" }));
  EXPECT_TRUE(round && std::get<UniformSky>(round->lamp).wholeSphere &&
    std::get<UniformSky>(round->lamp).up == sky.up)
    << "a sky all round";
}

TEST(LuminaireFields, FieldArraysThatDoNotFitAreRefused)
{
  auto disk = Carrier({ DiskLamp(), "" });
  SetText(disk, "LuminousFlux", "much");
  ExpectRefused(disk, "field array 'LuminousFlux' is a vtkStringArray, not numbers");
  disk->GetFieldData()->RemoveArray("LuminousFlux");
  ExpectRefused(disk, "field array 'LuminousFlux' is missing");
  SetNumbers(disk, "LuminousFlux", { std::nan("") });
  ExpectRefused(disk, "field array 'LuminousFlux' has the value nan");
  SetNumbers(disk, "LuminousFlux", { 1.0 });
  SetNumbers(disk, "LuminairePosition", { 1.0, 2.0 });
  ExpectRefused(disk, "field array 'LuminairePosition' has 2 values; 3 are wanted");
  SetNumbers(disk, "LuminairePosition", { 1.0, 2.0, 3.0 });
  EXPECT_TRUE(ReadLuminaire(disk).has_value())
    << "three numbers of one component are a position too";
  SetNumbers(disk, "LuminaireColour", { 0.0, 0.0, 0.0 });
  ExpectRefused(disk, "field array 'LuminaireColour' is (0, 0, 0)");
  SetNumbers(disk, "LuminaireName", { 1.0 });
  ExpectRefused(disk, "field array 'LuminaireName' is not one text");
  SetText(disk, "LuminaireType", "Candle");
  ExpectRefused(disk, "'LuminaireType' is 'Candle'; known types are Parallel, Point,");

  auto rectangle = Carrier({ RectangleLamp(), "" });
  SetNumbers(rectangle, "LuminaireSize", { 1.0 });
  ExpectRefused(rectangle, "field array 'LuminaireSize' has 1 values; 2 are wanted");
  auto sky = Carrier({ CieSky(), "" });
  SetNumbers(sky, "SkyType", { 1.5 });
  ExpectRefused(sky, "field array 'SkyType' is 1.5");
}

TEST(LuminaireFields, SolidsThatAreNoneAreRefused)
{
  auto data = Carrier({ SolidOfTypeB(), "" });
  SetText(data, "PhotometricType", "D");
  ExpectRefused(data, "field array 'PhotometricType' is 'D'");
  SetText(data, "PhotometricType", "C");
  SetNumbers(data, "PhotometricCandela", { 1.0, 2.0, 3.0, 4.0, 5.0 });
  ExpectRefused(data, "field array 'PhotometricCandela' has 5 values; 6 are wanted");
  SetNumbers(data, "PhotometricCandela", { 1.0, 2.0, 3.0, 4.0, 5.0, -6.0 });
  ExpectRefused(data, "field array 'PhotometricCandela' has values below 0");
  SetNumbers(data, "PhotometricPolar", { 0.0, 90.0, 90.0 });
  ExpectRefused(data, "field array 'PhotometricPolar' does not hold two or more rising angles");
  SetNumbers(data, "PhotometricPolar", { 0.0, 90.0, 190.0 });
  ExpectRefused(data, "field array 'PhotometricPolar' leaves [0, 180]");
  SetNumbers(data, "PhotometricPolar", { 0.0, 90.0, 180.0 });
  SetNumbers(data, "PhotometricAzimuth", { 0.0, 361.0 });
  ExpectRefused(data, "field array 'PhotometricAzimuth' covers more than 360");
}

TEST(LuminaireFields, ExitanceMakesASurfaceALamp)
{
  vtkNew<vtkPlaneSource> dark;
  dark->Update();
  EXPECT_FALSE(ReadLuminaire(dark->GetOutput())) << "a surface without Exitance is no luminaire";

  auto panels = Panels(1);
  panels->GetCellData()->GetArray("Exitance")->SetComponent(1, 0, 30.0);
  auto grey = ReadLuminaire(panels);
  CheckMesh(*grey, 1.0, 100.0f, 30.0f);
  EXPECT_EQ(grey->colour, Colour(1.0f)) << "one component is white";

  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(6);
  normals->Fill(0.0);
  normals->FillComponent(2, -5.0);
  panels->GetPointData()->SetNormals(normals);
  CheckMesh(*ReadLuminaire(panels), -1.0, 100.0f, 30.0f);

  auto coloured = Panels(3);
  vtkDataArray* exitance = coloured->GetCellData()->GetArray("Exitance");
  exitance->SetTuple3(0, 100.0, 0.0, 0.0);
  exitance->SetTuple3(1, 0.0, 0.0, 50.0);
  const auto mixed = ReadLuminaire(coloured);
  CheckMesh(*mixed, 1.0, Luminous({ 100.0f, 0.0f, 0.0f }), Luminous({ 0.0f, 0.0f, 50.0f }));
  EXPECT_EQ(mixed->colour, Colour(1.0f, 0.0f, 0.5f)) << "the colour of all its light together";
}

TEST(LuminaireFields, SurfacesThatCannotShineAreRefused)
{
  auto panels = Panels(1);
  vtkDataArray* exitance = panels->GetCellData()->GetArray("Exitance");
  exitance->SetTuple1(1, -2.0);
  ExpectRefused(panels, "cell 1: exitance -2 in array 'Exitance'");
  exitance->SetTuple1(1, std::nan(""));
  ExpectRefused(panels, "cell 1: exitance nan");
  exitance->SetTuple1(1, 2.0);
  panels->GetPoints()->SetPoint(4, 0.0, HUGE_VAL, 0.0);
  ExpectRefused(panels, "point 4: its coordinates (0, inf, 0), which cell 1 uses, are not finite");
  panels->GetPoints()->SetPoint(4, 0.0, 0.0, 0.0);
  exitance->SetNumberOfTuples(1);
  ExpectRefused(panels, "cell array 'Exitance' has 1 values for 2 cells");
  ExpectRefused(Panels(2), "cell array 'Exitance' has 2 components");

  auto empty = Panels(1);
  empty->SetPolys(nullptr);
  empty->SetStrips(nullptr);
  empty->GetCellData()->GetArray("Exitance")->SetNumberOfTuples(0);
  ExpectRefused(empty, "no polygons or triangle strips");
}
