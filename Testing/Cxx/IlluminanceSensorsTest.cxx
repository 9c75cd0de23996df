// SPDX-License-Identifier: BSD-3-Clause
// The filter Illuminance Sensors: layouts, arrays, what the map remembers, blocks, errors, abort.
#include "GatheringTools.h"
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminanceSensors.h"
#include "vtkIlluminationMap.h"
#include "vtkLuminaireSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkReverseSense.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

const double Pi = vtkMath::Pi();

/// A room of 6 x 4 x 3 from (0, 0, 0) on, seen from inside, its lengths times `scale`.
vtkSmartPointer<vtkPolyData> Room(double scale = 1.0)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.0, 6.0 * scale, 0.0, 4.0 * scale, 0.0, 3.0 * scale);
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(cube->GetOutputPort());
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOn();
  reverse->Update();
  return reverse->GetOutput();
}

/// A map of few photons, as sensors do not read it. Black, with a point lamp of 100 pi lm.
vtkSmartPointer<vtkIlluminationMap> LitRoom(double scale = 1.0)
{
  auto map = vtkSmartPointer<vtkIlluminationMap>::New();
  map->SetInputData(Room(scale));
  map->SetReflectance(0.0);
  map->SetLampType(vtkIlluminationMap::POINT);
  map->SetLampPosition(3.0 * scale, 2.0 * scale, 2.5 * scale);
  map->SetLuminousFlux(400.0 * Pi); // 100 cd
  map->SetMetresPerUnit(1.0 / scale);
  map->SetPhotons(2048);
  return map;
}

vtkSmartPointer<vtkIlluminanceSensors> SensorsIn(vtkAlgorithm* map)
{
  auto sensors = vtkSmartPointer<vtkIlluminanceSensors>::New();
  sensors->SetInputConnection(map->GetOutputPort());
  sensors->SetPhotons(2048);
  sensors->SetGatherRays(64);
  return sensors;
}

vtkPolyData* OutputOf(vtkIlluminanceSensors* sensors)
{
  sensors->Update();
  return vtkPolyData::SafeDownCast(sensors->GetOutputDataObject(0));
}

double At(vtkPolyData* data, const char* name, vtkIdType point, int component = 0)
{
  vtkDataArray* array = PointArray(data, name);
  return array ? array->GetComponent(point, component) : -1.0;
}

/// Sensors at points that are given.
vtkSmartPointer<vtkIlluminanceSensors> PointsIn(vtkAlgorithm* map, vtkDataObject* points)
{
  auto sensors = SensorsIn(map);
  sensors->SetInputDataObject(2, points);
  sensors->SetLayout(vtkIlluminanceSensors::POINTS);
  return sensors;
}

vtkSmartPointer<vtkPolyData> Line()
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(3.0, 2.0, 0.5);
  line->SetPoint2(6.0, 2.0, 0.5);
  line->SetResolution(3);
  line->Update();
  return line->GetOutput();
}

} // namespace

TEST(IlluminanceSensors, MakeAGridThatMeasuresTheMapsOwnLamp)
{
  const auto sensors = SensorsIn(LitRoom());
  vtkPolyData* grid = OutputOf(sensors);
  ASSERT_EQ(grid->GetNumberOfPoints(), 8 * 5); // 5 m by 3 m: p = 0.62 m
  EXPECT_EQ(grid->GetNumberOfPolys(), 7 * 4);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const double* place = grid->GetPoint(p);
    EXPECT_NEAR(place[2], 0.75, 1e-12);
    const double way[3] = { 3.0 - place[0], 2.0 - place[1], 1.75 };
    const double square = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
    const double across = 100.0 / square, length = std::sqrt(square);
    const double exact[] = { across * way[2] / length,
      across * std::hypot(way[0], way[1]) / length / Pi, across * 0.25 };
    EXPECT_NEAR(At(grid, "HorizontalIlluminance", p), exact[0], 1e-4 * exact[0]);
    EXPECT_NEAR(At(grid, "Illuminance", p), exact[0], 1e-4 * exact[0]);
    EXPECT_NEAR(At(grid, "CylindricalIlluminance", p), exact[1], 1e-4 * across);
    EXPECT_NEAR(At(grid, "SphericalIlluminance", p), exact[2], 1e-4 * across);
    for (int v = 0; v < 4; ++v)
    {
      const double towards = (v % 2 == 0 ? way[0] : way[1]) * (v < 2 ? 1.0 : -1.0);
      EXPECT_NEAR(At(grid, "VerticalIlluminance", p, v), across * std::max(0.0, towards / length),
        1e-4 * across);
    }
    EXPECT_EQ(At(grid, "Valid", p), 1.0);
    EXPECT_EQ(At(grid, "StandardErrorVertical", p, 2), 0.0);
    EXPECT_NEAR(At(grid, "SensorArea", p), 15.0 / 40.0, 1e-9);
  }
  EXPECT_EQ(PointArray(grid, "DaylightFactor"), nullptr);
  EXPECT_TRUE(Holds(FieldText(grid, "Notes"), "UGR is 0, since no luminaire has an area"));
}

TEST(IlluminanceSensors, AreTheSameInMillimetres)
{
  vtkPolyData* metres = nullptr;
  const auto one = SensorsIn(LitRoom());
  metres = OutputOf(one);
  const auto other = SensorsIn(LitRoom(1000.0));
  vtkPolyData* millimetres = OutputOf(other);
  ASSERT_EQ(millimetres->GetNumberOfPoints(), metres->GetNumberOfPoints());
  EXPECT_NEAR(millimetres->GetPoint(3)[2], 750.0, 1e-9);
  const double lux = At(metres, "HorizontalIlluminance", 3);
  EXPECT_NEAR(At(millimetres, "HorizontalIlluminance", 3), lux, 1e-4 * lux);
}

// All that the map was told counts here, too: materials by an array, and effects switched off.
TEST(IlluminanceSensors, RememberHowTheMapWasMade)
{
  vtkNew<vtkDoubleArray> rho;
  rho->SetName("Paint");
  vtkSmartPointer<vtkPolyData> room = Room();
  for (vtkIdType cell = 0; cell < room->GetNumberOfCells(); ++cell)
  {
    rho->InsertNextValue(0.8);
  }
  room->GetCellData()->AddArray(rho);
  const auto lux = [&](bool interreflection)
  {
    const auto map = LitRoom();
    map->SetInputData(room);
    map->SetReflectanceArray("Paint");
    map->SetInterreflection(interreflection);
    const auto sensors = SensorsIn(map);
    return At(OutputOf(sensors), "SphericalIlluminance", 11);
  };
  const double direct = At(OutputOf(SensorsIn(LitRoom())), "SphericalIlluminance", 11);
  EXPECT_NEAR(lux(false), direct, 1e-4 * direct);
  EXPECT_GT(lux(true), 1.5 * direct);
}

TEST(IlluminanceSensors, MeasureLuminairesAndTheirGlare)
{
  const auto map = LitRoom();
  vtkNew<vtkLuminaireSource> panel;
  panel->SetType(vtkLuminaireSource::RECTANGLE);
  panel->SetPosition(3.0, 2.0, 3.0);
  panel->SetSize(0.6, 0.6);
  panel->SetLuminousFlux(4000.0);
  map->SetReflectance(0.5);
  map->AddLuminaireConnection(panel->GetOutputPort());
  const auto sensors = SensorsIn(map);
  EXPECT_TRUE(Holds(ErrorOf(sensors), "Luminaires lit the map, and none is connected here"));
  sensors->AddLuminaireConnection(panel->GetOutputPort());
  sensors->SetHeight(1.2);
  vtkPolyData* grid = OutputOf(sensors);
  double most[4] = {};
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    for (int v = 0; v < 4; ++v)
    {
      EXPECT_GE(At(grid, "UGR", p, v), 0.0);
      EXPECT_LE(At(grid, "UGR", p, v), 100.0);
      most[v] = std::max(most[v], At(grid, "UGR", p, v));
    }
    EXPECT_GT(At(grid, "HorizontalIlluminance", p), 50.0);
  }
  for (const double glare : most)
  {
    EXPECT_GT(glare, 10.0);
    EXPECT_LT(glare, 35.0);
  }
}

TEST(IlluminanceSensors, TellDaylightFactorsUnderOvercastSkiesAlone)
{
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(0.0, 0.0, 0.0);
  ground->SetPoint1(6.0, 0.0, 0.0);
  ground->SetPoint2(0.0, 4.0, 0.0);
  const auto map = LitRoom();
  map->SetInputConnection(ground->GetOutputPort());
  vtkNew<vtkLuminaireSource> sky;
  sky->SetType(vtkLuminaireSource::CIE_SKY);
  sky->SetSkyType(16);
  map->AddLuminaireConnection(sky->GetOutputPort());
  const auto sensors = SensorsIn(map);
  sensors->SetGatherRays(1024);
  sensors->AddLuminaireConnection(sky->GetOutputPort());
  vtkPolyData* grid = OutputOf(sensors);
  const double factor = At(grid, "DaylightFactor", 20);
  EXPECT_NEAR(factor, 100.0, 5.0 * At(grid, "StandardErrorDaylightFactor", 20)); // nothing hides it
  EXPECT_LT(At(grid, "StandardErrorDaylightFactor", 20), 1.0);
  EXPECT_NEAR(
    At(grid, "CylindricalIlluminance", 20) / At(grid, "HorizontalIlluminance", 20), 0.39618, 0.02);
  sky->SetSkyType(12);
  grid = OutputOf(sensors);
  EXPECT_EQ(PointArray(grid, "DaylightFactor"), nullptr);
  EXPECT_TRUE(Holds(FieldText(grid, "Notes"), "there is no DaylightFactor, since luminaire"));
  EXPECT_TRUE(Holds(FieldText(grid, "Notes"), "is no overcast sky"));
}

TEST(IlluminanceSensors, ReadPointsOfAnyDataAndPassThemThrough)
{
  const auto map = LitRoom();
  const auto line = Line();
  const auto sensors = PointsIn(map, line);
  vtkPolyData* output = OutputOf(sensors);
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  EXPECT_EQ(output->GetNumberOfLines(), 1);
  const double first = At(output, "Illuminance", 0); // `output` ends where composite data enters
  EXPECT_NEAR(first, 25.0, 1e-3);                    // 100 cd at 2 m, and it faces up
  EXPECT_TRUE(Holds(FieldText(output, "Notes"), "4 sensors have no normal: they face up"));
  EXPECT_EQ(line->GetPointData()->GetNumberOfArrays(), 1); // texture coordinates of the source

  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->SetOrigin(2.0, 1.0, 1.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, line);
  blocks->SetBlock(2, image);
  sensors->SetInputDataObject(2, blocks);
  sensors->Update();
  auto* result = vtkMultiBlockDataSet::SafeDownCast(sensors->GetOutputDataObject(0));
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(At(vtkPolyData::SafeDownCast(result->GetBlock(0)), "Illuminance", 0), first);
  auto* ofImage = vtkImageData::SafeDownCast(result->GetBlock(2));
  ASSERT_NE(ofImage, nullptr);
  EXPECT_EQ(ofImage->GetPointData()->GetArray("VerticalIlluminance")->GetNumberOfTuples(), 8);
}

TEST(IlluminanceSensors, TakeTheNormalsOfAMesh)
{
  vtkNew<vtkPlaneSource> plane; // faces -x, towards a lamp there
  plane->SetOrigin(5.0, 1.9, 2.4);
  plane->SetPoint1(5.0, 1.9, 2.6);
  plane->SetPoint2(5.0, 2.1, 2.4);
  plane->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(plane->GetOutput()->GetPoints());
  bare->SetPolys(plane->GetOutput()->GetPolys());
  const auto map = LitRoom();
  const auto with = PointsIn(map, plane->GetOutput()), without = PointsIn(map, bare);
  const double exact = 100.0 * 2.0 / std::pow(4.0 + 0.02, 1.5);
  EXPECT_NEAR(At(OutputOf(with), "Illuminance", 0), exact, 1e-4 * exact);
  EXPECT_NEAR(At(OutputOf(without), "Illuminance", 0), exact, 1e-4 * exact);
}

TEST(IlluminanceSensors, LieOverPolygonsAndMarkWhatIsOutside)
{
  vtkNew<vtkPlaneSource> floor; // larger than the room
  floor->SetOrigin(0.0, 0.0, 0.0);
  floor->SetPoint1(12.0, 0.0, 0.0);
  floor->SetPoint2(0.0, 4.0, 0.0);
  const auto map = LitRoom();
  const auto sensors = SensorsIn(map);
  sensors->SetInputConnection(2, floor->GetOutputPort());
  sensors->SetLayout(vtkIlluminanceSensors::POLYGONS);
  sensors->SetSpacing(0.5);
  vtkPolyData* grid = OutputOf(sensors);
  ASSERT_EQ(grid->GetNumberOfPoints(), 22 * 6);
  int outside = 0;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const bool inside = grid->GetPoint(p)[0] < 6.0;
    EXPECT_EQ(At(grid, "Valid", p), inside ? 1.0 : 0.0);
    EXPECT_EQ(At(grid, "HorizontalIlluminance", p) > 0.0, inside);
    outside += inside ? 0 : 1;
  }
  EXPECT_TRUE(Holds(FieldText(grid, "Notes"), std::to_string(outside) + " of 132 sensors"));
}

TEST(IlluminanceSensors, RefuseWhatMakesNoSense)
{
  const auto map = LitRoom();
  const auto sensors = SensorsIn(map);
  const auto expect = [&](const char* words)
  {
    EXPECT_TRUE(Holds(ErrorOf(sensors), words));
    EXPECT_EQ(sensors->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  };
  sensors->SetMargin(2.0);
  expect("margin of 2 m leaves nothing of an area of 6 m by 4 m");
  sensors->SetMargin(0.5);
  sensors->SetUp(0.0, 0.0, 0.0);
  expect("up is no direction");
  sensors->SetUp(0.0, 0.0, 1.0);
  sensors->SetGatherRays(3);
  expect("GatherRays is 3; it must be within [16, 16384]");
  sensors->SetGatherRays(64);
  sensors->SetGridBounds(1.0, 0.0, 0.0, 1.0, 0.0, 1.0);
  expect("GridBounds run from 1 to 0 along x");
  sensors->SetGridBounds(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  sensors->SetLayout(vtkIlluminanceSensors::POLYGONS);
  expect("no polygons are connected to Sensors");
  sensors->SetLayout(vtkIlluminanceSensors::POINTS);
  expect("no data set with points is connected to Sensors");
  sensors->SetLayout(vtkIlluminanceSensors::BOX);
  sensors->SetInputData(Room());
  expect("no field array 'IlluminationMapSettings'");
}

TEST(IlluminanceSensors, NameASensorWhoseNormalIsNone)
{
  const auto line = Line();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, i == 2 ? 0.0 : 1.0);
  }
  line->GetPointData()->SetNormals(normals);
  const auto sensors = PointsIn(LitRoom(), line);
  EXPECT_TRUE(Holds(ErrorOf(sensors), "sensor 2: its normal is (0, 0, 0)"));
  EXPECT_EQ(PointArray(OutputOf(sensors), "Valid"), nullptr); // and the points pass through
}

TEST(IlluminanceSensors, StopWhenTheUserWantsIt)
{
  const auto map = LitRoom();
  map->Update();
  const auto sensors = SensorsIn(map);
  sensors->SetPhotons(2000000000);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  sensors->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(PointArray(OutputOf(sensors), "Valid"), nullptr);
}

TEST(IlluminanceSensors, WarnOfLightThatMirrorsSend)
{
  const auto map = LitRoom();
  map->SetSpecularReflectance(0.5);
  const auto sensors = SensorsIn(map);
  map->Update();
  const CaughtMessages messages;
  vtkPolyData* grid = OutputOf(sensors);
  EXPECT_EQ(messages->Warnings, 1);
  EXPECT_TRUE(Holds(messages->Text, "straight from lamps by mirrors, gloss or clear bodies"));
  EXPECT_TRUE(Holds(FieldText(grid, "Notes"), "Sensors do not see such light"));
}
