// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialTools.h"

#include "vtkIlluminatedAppearance.h"
#include "vtkIlluminationMap.h"

#include "PhotonTransport/appearance/DisplayTransform.h"
#include "PhotonTransport/geometry/Pi.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPolygon.h"
#include "vtkReverseSense.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <limits>

using PhotonTransport::Pi;

namespace
{

/// Reflectances, exitances and the luminous weights are of single precision: relative.
constexpr double Rounding = 1e-7;

/// Adds a point array of one tuple for all points.
void AddPoints(vtkPolyData* data, const char* name, std::vector<double> tuple)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (std::size_t c = 0; c < tuple.size(); ++c)
  {
    array->FillComponent(static_cast<int>(c), tuple[c]);
  }
  data->GetPointData()->AddArray(array);
}

/// Four cells of a plane with nine points and normals along z, lit by 500 lx.
vtkSmartPointer<vtkPolyData> LitPlane()
{
  auto plane = Plane();
  AddPoints(plane, "Illuminance", { 500.0 });
  return plane;
}

vtkSmartPointer<vtkIlluminatedAppearance> Shown(vtkDataObject* data)
{
  auto filter = vtkSmartPointer<vtkIlluminatedAppearance>::New();
  filter->SetInputDataObject(data);
  filter->Update();
  return filter;
}

double At(vtkPolyData* data, const char* array, vtkIdType point, int component = 0)
{
  vtkDataArray* values = PointArray(data, array);
  return values ? values->GetComponent(point, component) : -1.0;
}

std::array<std::uint8_t, 3> ColourAt(vtkPolyData* data, vtkIdType point)
{
  std::array<std::uint8_t, 3> colour{};
  auto* array = vtkUnsignedCharArray::SafeDownCast(PointArray(data, "DisplayColours"));
  if (array)
  {
    array->GetTypedTuple(point, colour.data());
  }
  return colour;
}

/// Luminance (cd/m²) at a corner of a cell.
double AtCorner(vtkPolyData* data, vtkIdType cell, int corner)
{
  vtkNew<vtkIdList> points;
  data->GetCellPoints(cell, points);
  return At(data, "Luminance", points->GetId(corner));
}

/// Whether every polygon winds counter-clockwise seen from +z.
bool AllFaceUp(vtkPolyData* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(cell, ids);
    double normal[3];
    vtkPolygon::ComputeNormal(
      data->GetPoints(), static_cast<int>(ids->GetNumberOfIds()), ids->GetPointer(0), normal);
    if (!(normal[2] > 0.0))
    {
      return false;
    }
  }
  return true;
}

} // namespace

TEST(IlluminatedAppearance, MattWallHasTheLuminanceOfLambertsLaw)
{
  auto plane = LitPlane();
  AddCells<vtkDoubleArray>(plane, "DiffuseReflectance", 1, { 0.5, 0.5, 0.5, 0.5 });
  AddCells<vtkDoubleArray>(plane, "Exitance", 1, { 0.0, 0.0, 0.0, 0.0 });
  auto filter = Shown(plane);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 9) << "cells of one look share their points";
  for (vtkIdType p = 0; p < 9; ++p)
  {
    EXPECT_NEAR(At(output, "Luminance", p), 0.5 * 500.0 / Pi, 1e-9);
  }
  EXPECT_EQ(PointArray(output, "LuminanceRGB"), nullptr) << "there is no colour";
  EXPECT_EQ(output->GetPointData()->GetScalars(), PointArray(output, "DisplayColours"));
  EXPECT_NEAR(FieldValue(output, "AdaptationLuminance"), 250.0 / Pi, 1e-9);
  // Exposure by hand: mid grey, 0.18 of white, is 117.6 of 255. What fits is not compressed.
  EXPECT_EQ(ColourAt(output, 4), (std::array<std::uint8_t, 3>{ 118, 118, 118 }));
  // At a quarter of it as mid grey the wall has 0.72 of white, which is 220.6, ...
  filter->SetAdaptationLuminance(62.5 / Pi);
  filter->Update();
  EXPECT_EQ(ColourAt(filter->GetOutput(), 4), (std::array<std::uint8_t, 3>{ 221, 221, 221 }));
  // ... and at a tenth 1.8 of white: as the brightest place it is white.
  filter->SetAdaptationLuminance(25.0 / Pi);
  filter->Update();
  EXPECT_EQ(ColourAt(filter->GetOutput(), 4), (std::array<std::uint8_t, 3>{ 255, 255, 255 }));
  // With white at 4 * 1.8 = 7.2 of Reinhard's curve: 1.8 (1 + 1.8 / 51.84) / 2.8 = 0.66518, 213.0.
  filter->SetWhiteLuminance(1000.0 / Pi);
  filter->Update();
  EXPECT_EQ(ColourAt(filter->GetOutput(), 4), (std::array<std::uint8_t, 3>{ 213, 213, 213 }));
  // At 100 times that luminance as mid grey it is 0.0018 of white, on the straight part: 5.93.
  filter->SetAdaptationLuminance(25000.0 / Pi);
  filter->Update();
  EXPECT_EQ(ColourAt(filter->GetOutput(), 4), (std::array<std::uint8_t, 3>{ 6, 6, 6 }));
}

TEST(IlluminatedAppearance, ColoursOfLightAndSurfaceMultiply)
{
  auto plane = LitPlane();
  AddPoints(plane, "IlluminanceRGB", { 800.0, 450.0, 112.18836 });
  AddCells<vtkFloatArray>(plane, "DiffuseReflectance", 3,
    { 0.5, 0.25, 0.125, 0.5, 0.25, 0.125, 0.5, 0.25, 0.125, 0.5, 0.25, 0.125 });
  auto filter = Shown(plane);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_NEAR(At(output, "LuminanceRGB", 4, 0), 400.0 / Pi, 1e-9);
  EXPECT_NEAR(At(output, "LuminanceRGB", 4, 1), 112.5 / Pi, 1e-9);
  EXPECT_NEAR(At(output, "LuminanceRGB", 4, 2), 14.023545 / Pi, 1e-9);
  EXPECT_NEAR(
    At(output, "Luminance", 4), (0.2126 * 400.0 + 0.7152 * 112.5 + 0.0722 * 14.023545) / Pi, 1e-5);

  // A smoothed map has the luminance, and IlluminanceRGB its colour.
  const double luminous = 0.2126 * 800.0 + 0.7152 * 450.0 + 0.0722 * 112.18836;
  AddPoints(plane, "IlluminanceSmoothed", { 2.0 * luminous });
  plane->Modified();
  filter->Update();
  EXPECT_NEAR(At(filter->GetOutput(), "LuminanceRGB", 4, 0), 800.0 / Pi, 1e-4);
  EXPECT_TRUE(Holds(FieldText(filter->GetOutput(), "AppearanceNotes"), "'IlluminanceSmoothed'"));
  filter->SetIlluminanceArray("Illuminance");
  filter->Update();
  EXPECT_NEAR(At(filter->GetOutput(), "LuminanceRGB", 4, 0), 400.0 / Pi, 1e-9);

  // The arriving light looks white: a grey surface is grey in it.
  filter->SetReflectanceArray("None");
  filter->SetWhiteBalance(vtkIlluminatedAppearance::AUTOMATIC);
  filter->Update();
  const auto grey = ColourAt(filter->GetOutput(), 4);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  filter->SetWhiteBalance(vtkIlluminatedAppearance::BY_COLOUR);
  filter->SetWhiteColour(8.0, 4.5, 1.1218836);
  filter->Update();
  EXPECT_EQ(ColourAt(filter->GetOutput(), 4), grey);
  filter->SetWhiteBalance(vtkIlluminatedAppearance::NO_BALANCE);
  filter->SetHighlightCompression(0.0);
  filter->Update();
  const auto warm = ColourAt(filter->GetOutput(), 4);
  EXPECT_TRUE(warm[0] > warm[1] && warm[1] > warm[2]) << "without balance it is warm";
}

TEST(IlluminatedAppearance, PointsAreSplitWhereMaterialsMeet)
{
  auto plane = LitPlane();
  AddCells<vtkDoubleArray>(plane, "Rho", 1, { 0.2, 0.8, 0.2, 0.8 });
  AddCells<vtkDoubleArray>(plane, "Exitance", 1, { 0.0, 0.0, 0.0, 3000.0 });
  vtkNew<vtkIlluminatedAppearance> filter;
  filter->SetInputData(plane);
  filter->SetReflectanceArray("Rho");
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  // The middle column of three points serves left and right; its upper two, and the point on the
  // right between the two cells there, serve the shining cell too: 3 + 2 + 1 - 1, as the topmost of
  // the column is not used by the cell below.
  EXPECT_EQ(output->GetNumberOfPoints(), 9 + 5);
  EXPECT_EQ(output->GetNumberOfCells(), 4);
  const double expected[] = { 100.0 / Pi, 400.0 / Pi, 100.0 / Pi, 3400.0 / Pi };
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      EXPECT_NEAR(AtCorner(output, cell, corner), expected[cell], Rounding * expected[cell])
        << cell << " " << corner;
    }
  }
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const auto original = static_cast<vtkIdType>(At(output, "OriginalPointIds", p));
    EXPECT_TRUE(p < 9 ? original == p : original < 9);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(output->GetPoint(p)[c], plane->GetPoint(original)[c]);
    }
    EXPECT_EQ(At(output, "Normals", p, 2), 1.0) << "copies have the arrays of their originals";
  }
  EXPECT_EQ(plane->GetNumberOfPoints(), 9) << "the input is as it was";
  // What shines itself does not count: a quarter of the area each has 100, 400 and 100 / pi.
  EXPECT_NEAR(FieldValue(output, "AdaptationLuminance"), std::cbrt(100.0 * 400.0 * 100.0) / Pi,
    51.0 * Rounding);
  EXPECT_NEAR(FieldValue(output, "WhiteLuminance"), 400.0 / Pi, 128.0 * Rounding);
  filter->SetExitanceArray("None");
  filter->Update();
  EXPECT_NEAR(AtCorner(filter->GetOutput(), 3, 0), 400.0 / Pi, 128.0 * Rounding)
    << "nothing shines";
}

TEST(IlluminatedAppearance, LightThatPassesShadesCounts)
{
  auto plane = LitPlane();
  AddCells<vtkDoubleArray>(plane, "DiffuseReflectance", 1, { 0.3, 0.3, 0.3, 0.3 });
  AddCells<vtkDoubleArray>(plane, "DiffuseTransmittance", 1, { 0.4, 0.4, 0.4, 0.4 });
  auto filter = Shown(plane);
  EXPECT_NEAR(At(filter->GetOutput(), "Luminance", 0), 150.0 / Pi, 48.0 * Rounding);
  EXPECT_TRUE(Holds(FieldText(filter->GetOutput(), "AppearanceNotes"), "RegisterBackSide"));
  AddPoints(plane, "IlluminanceBack", { 2000.0 });
  plane->Modified();
  filter->Update();
  EXPECT_NEAR(At(filter->GetOutput(), "Luminance", 0), 950.0 / Pi, 303.0 * Rounding);
}

TEST(IlluminatedAppearance, CellsFaceTheLitSide)
{
  auto plane = LitPlane();
  vtkNew<vtkReverseSense> reversed; // the cells only: the lit side is still above
  reversed->SetInputData(plane);
  reversed->ReverseCellsOn();
  reversed->ReverseNormalsOff();
  reversed->Update();
  EXPECT_FALSE(AllFaceUp(reversed->GetOutput()));
  EXPECT_TRUE(AllFaceUp(Shown(reversed->GetOutput())->GetOutput()));
  EXPECT_TRUE(AllFaceUp(Shown(plane)->GetOutput()));

  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(reversed->GetOutput());
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  vtkNew<vtkTriangleFilter> back;
  back->SetInputData(Shown(strips->GetOutput())->GetOutput());
  back->Update();
  vtkNew<vtkPolyData> withArea;
  withArea->ShallowCopy(back->GetOutput());
  int up = 0;
  int down = 0;
  for (vtkIdType cell = 0; cell < withArea->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    withArea->GetCellPoints(cell, ids);
    double normal[3];
    vtkPolygon::ComputeNormal(withArea->GetPoints(), 3, ids->GetPointer(0), normal);
    up += normal[2] > 0.0 ? 1 : 0;
    down += normal[2] < 0.0 ? 1 : 0;
  }
  EXPECT_EQ(up, 8) << "strips too";
  EXPECT_EQ(down, 0);
}

TEST(IlluminatedAppearance, TakesWhatTheIlluminationMapWasMadeWith)
{
  auto plane = Plane();
  AddCells<vtkDoubleArray>(plane, "Rho", 1, { 0.2, 0.2, 0.8, 0.8 });
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(plane);
  map->SetReflectanceArray("Rho");
  map->SetPhotons(20000);
  vtkNew<vtkIlluminatedAppearance> filter;
  filter->SetInputConnection(map->GetOutputPort());
  const auto expectReflectance = [&](double reflectance, vtkIdType cell)
  {
    filter->Update();
    vtkNew<vtkIdList> points;
    filter->GetOutput()->GetCellPoints(cell, points);
    const vtkIdType p = points->GetId(0);
    EXPECT_NEAR(At(filter->GetOutput(), "Luminance", p),
      reflectance * At(filter->GetOutput(), "Illuminance", p) / Pi, 1e-4);
  };
  expectReflectance(0.2, 0);
  expectReflectance(0.8, 3);
  map->SetReflectanceArray("");
  map->SetReflectance(0.3);
  expectReflectance(0.3, 0);
  filter->SetReflectanceArray("None");
  filter->SetReflectance(0.7);
  expectReflectance(0.7, 0);

  filter->SetReflectanceArray("Automatic");
  AddCells<vtkDoubleArray>(plane, "DiffuseReflectance", 1, { 0.6, 0.6, 0.6, 0.6 });
  expectReflectance(0.6, 0);
  map->SetUseMaterialArrays(false);
  expectReflectance(0.3, 0);
}

TEST(IlluminatedAppearance, ShinesAsTheIlluminationMapsOwnLamp)
{
  auto plane = Plane();
  AddCells<vtkDoubleArray>(plane, "Shine", 1, { 0.0, 0.0, 90.0, 90.0 });
  AddCells<vtkDoubleArray>(plane, "Exitance", 1, { 7.0, 7.0, 7.0, 7.0 });
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(plane);
  map->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  map->SetExitanceArray("Shine");
  map->SetReflectance(0.0);
  map->SetPhotons(20000);
  vtkNew<vtkIlluminatedAppearance> filter;
  filter->SetInputConnection(map->GetOutputPort());
  const auto expectExitance = [&](double exitance, vtkIdType cell)
  {
    filter->Update();
    vtkNew<vtkIdList> points;
    filter->GetOutput()->GetCellPoints(cell, points);
    EXPECT_NEAR(At(filter->GetOutput(), "Luminance", points->GetId(0)), exitance / Pi, 1e-5);
  };
  expectExitance(0.0, 0);
  expectExitance(90.0, 3);
  map->SetLampType(vtkIlluminationMap::PARALLEL); // the array Shine is not in use
  expectExitance(7.0, 0);
}

TEST(IlluminatedAppearance, BlocksAreOneSurface)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  auto dark = LitPlane();
  AddPoints(dark, "Illuminance", { 5.0 });
  blocks->SetBlock(0, dark);
  blocks->SetBlock(1, vtkNew<vtkUnstructuredGrid>());
  blocks->SetBlock(3, LitPlane());
  auto filter = Shown(blocks);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  auto* lit = vtkPolyData::SafeDownCast(output->GetBlock(3));
  ASSERT_TRUE(lit && PointArray(lit, "DisplayColours"));
  EXPECT_NEAR(At(lit, "Luminance", 0), 250.0 / Pi, 1e-9) << "reflectance 0.5 by default";
  EXPECT_NEAR(FieldValue(output, "AdaptationLuminance"), std::sqrt(2.5 * 250.0) / Pi, 1e-9)
    << "one exposure for all blocks";
  EXPECT_TRUE(output->GetBlock(1) && output->GetBlock(1)->IsA("vtkUnstructuredGrid"));
}

TEST(IlluminatedAppearance, ColoursAreThoseOfTheCore)
{
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(Plane());
  map->SetPhotons(20000);
  map->SetLampType(vtkIlluminationMap::POINT);
  map->Update();
  auto filter = Shown(map->GetOutput());
  vtkPolyData* output = filter->GetOutput();
  PhotonTransport::DisplaySettings settings;
  settings.adaptationLuminance = FieldValue(output, "AdaptationLuminance");
  settings.whiteLuminance = FieldValue(output, "WhiteLuminance");
  const PhotonTransport::DisplayTransform display(settings);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(ColourAt(output, p), display(glm::dvec3(At(output, "Luminance", p))));
  }
}

TEST(IlluminatedAppearance, ErrorsLetTheInputPassThrough)
{
  auto plane = LitPlane();
  AddCells<vtkDoubleArray>(plane, "Rho", 1, { 0.2, 0.2, 1.5, 0.2 });
  vtkNew<vtkIlluminatedAppearance> filter;
  filter->SetInputData(plane);
  const auto expect = [&](const std::string& message)
  {
    EXPECT_TRUE(Holds(ErrorOf(filter), message));
    EXPECT_TRUE(filter->GetOutput()->GetNumberOfPoints() == 9 &&
      !PointArray(filter->GetOutput(), "Luminance"))
      << "the input passes through";
  };
  filter->SetReflectanceArray("Rho");
  expect("cell 2: 1.5 in cell array 'Rho' is outside [0, 1]");
  filter->SetReflectanceArray("Missing");
  expect("there is no cell array 'Missing'");
  filter->SetReflectanceArray("Automatic");
  filter->SetIlluminanceArray("Lux");
  expect("there is no point array 'Lux'; the input must be lit by Illumination Map");
  filter->SetIlluminanceArray("Automatic");
  filter->SetExitanceArray("Rho2");
  expect("there is no cell array 'Rho2'");
  filter->SetExitanceArray("Automatic");
  filter->SetReflectance(-0.1);
  expect("Reflectance is -0.1; it must be within [0, 1]");
  filter->SetReflectance(0.5);
  filter->SetAdaptationLuminance(std::nan(""));
  expect("AdaptationLuminance is nan; it must be a finite luminance >= 0 in cd/m^2");
  filter->SetAdaptationLuminance(0.0);
  filter->SetHighlightCompression(2.0);
  expect("HighlightCompression is 2; it must be within [0, 1]");
  filter->SetHighlightCompression(1.0);
  filter->SetWhiteColour(0.0, 0.0, 0.0);
  expect("WhiteColour is 0 0 0");
  filter->SetWhiteColour(1.0, 1.0, 1.0);
  PointArray(plane, "Illuminance")->SetTuple1(7, std::numeric_limits<double>::infinity());
  plane->Modified();
  expect("point 7: inf in point array 'Illuminance' is not a finite number >= 0");
  AddPoints(plane, "Illuminance", { 0.0 });
  plane->Modified();
  EXPECT_TRUE(ErrorOf(filter).empty());
  EXPECT_EQ(ColourAt(filter->GetOutput(), 0), (std::array<std::uint8_t, 3>{ 0, 0, 0 }))
    << "what is dark is black";
}

TEST(IlluminatedAppearance, AnAbortLetsTheInputPassThrough)
{
  vtkNew<vtkIlluminatedAppearance> filter;
  filter->SetInputData(LitPlane());
  filter->SetAbortExecute(1);
  vtkNew<vtkCallbackCommand> keep; // the executive clears the flag before an execution
  keep->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::StartEvent, keep);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
  EXPECT_EQ(PointArray(filter->GetOutput(), "Luminance"), nullptr);
}
