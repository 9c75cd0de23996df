// SPDX-License-Identifier: BSD-3-Clause
// The outputs Photons and Photon Paths: arrays, flux, blocks, a run that goes on. Which photons
// they are: Core/PhotonFollowerTest.
#include "GatheringTools.h"
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkTriangle.h"

#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace
{

vtkPolyData* Output(vtkIlluminationMap* map, int port)
{
  return vtkPolyData::SafeDownCast(map->GetOutputDataObject(port));
}

/// Triangles that share no points, so that a facet's flux follows from the map.
vtkSmartPointer<vtkPolyData> Torn(vtkPolyData* surface)
{
  auto torn = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(surface->GetCell(c)->GetPointId(i), p[i]);
    }
    double normal[3];
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    cells->InsertNextCell(3);
    for (const auto& corner : p)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corner));
      normals->InsertNextTuple(normal);
    }
  }
  torn->SetPoints(points);
  torn->SetPolys(cells);
  torn->GetPointData()->SetNormals(normals);
  return torn;
}

/// [cell] Flux that arrives by the map with FLAT, lm, on triangles that share no points.
/// @param array A map, lx, of which one component counts.
std::vector<double> FluxOfMap(
  vtkPolyData* lit, const char* array = "Illuminance", int component = 0)
{
  std::vector<double> flux;
  for (vtkIdType c = 0; c < lit->GetNumberOfCells(); ++c)
  {
    double p[3][3];
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType point = lit->GetCell(c)->GetPointId(i);
      lit->GetPoint(point, p[i]);
      sum += PointArray(lit, array)->GetComponent(point, component);
    }
    flux.push_back(vtkTriangle::TriangleArea(p[0], p[1], p[2]) * sum / 3.0);
  }
  return flux;
}

/// [cell] The same by the photons on fronts. @param array Of fluxes, lm.
std::vector<double> FluxOfPhotons(
  vtkPolyData* photons, vtkIdType cells, const char* array = "Flux", int component = 0)
{
  std::vector<double> flux(static_cast<std::size_t>(cells), 0.0);
  for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); ++i)
  {
    if (PointArray(photons, "Side")->GetTuple1(i) > 0.0)
    {
      flux[static_cast<std::size_t>(PointArray(photons, "OriginalCellIds")->GetTuple1(i))] +=
        PointArray(photons, array)->GetComponent(i, component);
    }
  }
  return flux;
}

vtkSmartPointer<vtkIlluminationMap> LitRoom(vtkPolyData* room, int most)
{
  auto map = vtkSmartPointer<vtkIlluminationMap>::New();
  map->SetInputData(room);
  map->SetLampType(vtkIlluminationMap::POINT);
  map->SetLampPosition(0.1, 0.05, 0.15);
  map->SetRegistration(vtkIlluminationMap::FLAT);
  map->SetPhotons(20000);
  map->SetMaximumPhotons(most);
  return map;
}

constexpr int Everything = 10'000'000;

} // namespace

TEST(IlluminationMapPhotons, AreNotThereUnlessAskedFor)
{
  const auto map = LitRoom(RoundRoom(12), 0);
  map->Update();
  EXPECT_EQ(Output(map, 2)->GetNumberOfPoints(), 0);
  EXPECT_EQ(Output(map, 3)->GetNumberOfPoints(), 0);
  const double without = FieldValue(map->GetOutputDataObject(0), "MemoryNeeded");
  map->SetMaximumPhotons(100000);
  map->Update();
  EXPECT_GT(Output(map, 2)->GetNumberOfPoints(), 0);
  EXPECT_GT(FieldValue(map->GetOutputDataObject(0), "MemoryNeeded"), without + 100000 * 140.0);
}

TEST(IlluminationMapPhotons, CarryTheFluxOfTheFlatMapToEachFacet)
{
  const auto room = Torn(RoundRoom(12));
  const auto map = LitRoom(room, Everything);
  map->Update();
  vtkPolyData* photons = Output(map, 2);
  EXPECT_EQ(FieldValue(photons, "PhotonsFollowed"),
    FieldValue(map->GetOutputDataObject(0), "PhotonsEmitted"));
  EXPECT_EQ(photons->GetNumberOfVerts(), photons->GetNumberOfPoints()) << "a vertex each";
  const std::vector<double> ofMap = FluxOfMap(map->GetOutput());
  const std::vector<double> ofPhotons = FluxOfPhotons(photons, room->GetNumberOfCells());
  for (std::size_t c = 0; c < ofMap.size(); ++c)
  {
    EXPECT_NEAR(ofPhotons[c], ofMap[c], 1e-6 * ofMap[c]) << "cell " << c;
  }
  for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); i += 101)
  {
    double direction[3];
    PointArray(photons, "Direction")->GetTuple(i, direction);
    EXPECT_NEAR(vtkMath::Norm(direction), 1.0, 1e-5);
    double point[3];
    photons->GetPoint(i, point);
    EXPECT_NEAR(vtkMath::Norm(point), 0.49, 0.02) << "on the room's facets";
    EXPECT_EQ(PointArray(photons, "Luminaire")->GetTuple1(i), 0.0);
  }
  EXPECT_EQ(PointArray(photons, "FluxRGB"), nullptr) << "there are no colours";
  EXPECT_EQ(PointArray(photons, "BlockIndex"), nullptr) << "nor blocks";
}

// Photons that start at an opening carry another flux than those that start outdoors.
TEST(IlluminationMapPhotons, ThroughAnOpeningCarryTheFluxOfTheFlatMapByColour)
{
  const auto bowl = Torn(RoundRoom(12, 90.0));
  vtkNew<vtkDoubleArray> red;
  red->SetName("DiffuseReflectance");
  red->SetNumberOfComponents(3);
  for (vtkIdType c = 0; c < bowl->GetNumberOfCells(); ++c)
  {
    red->InsertNextTuple3(0.8, 0.4, 0.2);
  }
  bowl->GetCellData()->AddArray(red);
  vtkNew<vtkLuminaireSource> sky;
  sky->SetType(vtkLuminaireSource::UNIFORM_SKY);
  const auto map = LitRoom(bowl, Everything);
  map->AddLuminaireConnection(sky->GetOutputPort());
  map->SetPhotons(40000);
  map->Update();
  EXPECT_TRUE(Holds(FieldText(map->GetOutput(), "Notes"), "openings used: 1"));
  vtkPolyData* photons = Output(map, 2);
  EXPECT_EQ(FieldValue(photons, "PhotonsFollowed"), FieldValue(map->GetOutput(), "PhotonsEmitted"));
  std::set<double> fluxes;
  for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); ++i)
  {
    fluxes.insert(PointArray(photons, "Flux")->GetTuple1(i));
  }
  EXPECT_GT(fluxes.size(), 1u) << "or the weights of starts are not tested here";

  const vtkIdType cells = bowl->GetNumberOfCells();
  const auto expectSame = [&](const char* ofMap, const char* ofPhotons, int component)
  {
    const std::vector<double> expected = FluxOfMap(map->GetOutput(), ofMap, component);
    const std::vector<double> found = FluxOfPhotons(photons, cells, ofPhotons, component);
    EXPECT_GT(std::accumulate(found.begin(), found.end(), 0.0), 0.0) << ofPhotons;
    for (std::size_t c = 0; c < expected.size(); ++c)
    {
      // Of the map's rounding, to 2^-28 a hit and to single precision at its points.
      EXPECT_NEAR(found[c], expected[c], 2e-6 * expected[c]) << ofPhotons << ", cell " << c;
    }
  };
  expectSame("Illuminance", "Flux", 0);
  for (int channel = 0; channel < 3; ++channel)
  {
    expectSame("IlluminanceRGB", "FluxRGB", channel);
  }
}

TEST(IlluminationMapPhotons, GoOnWithTheRunAndStayTheFirst)
{
  const auto room = RoundRoom(12);
  const auto map = LitRoom(room, 3000);
  map->Update();
  const double seconds = FieldValue(map->GetOutputDataObject(0), "Seconds");
  vtkNew<vtkPolyData> before;
  before->DeepCopy(Output(map, 2));
  EXPECT_LE(before->GetNumberOfPoints(), 3000);
  EXPECT_GT(before->GetNumberOfPoints(), 2900);
  map->SetNumberOfThreads(1);
  map->SetPhotons(60000);
  map->Update();
  EXPECT_TRUE(SameValues(PointArray(before, "Flux"), PointArray(Output(map, 2), "Flux")));
  EXPECT_TRUE(SameValues(
    PointArray(before, "OriginalCellIds"), PointArray(Output(map, 2), "OriginalCellIds")));
  const double traced = FieldValue(map->GetOutputDataObject(0), "Seconds");
  EXPECT_NE(traced, seconds);
  map->SetMaximumPhotons(100);
  map->SetPhotonPaths(10);
  map->Update();
  EXPECT_EQ(FieldValue(map->GetOutputDataObject(0), "Seconds"), traced) << "nothing traced anew";
  EXPECT_LE(Output(map, 2)->GetNumberOfPoints(), 100);
  EXPECT_EQ(Output(map, 3)->GetNumberOfLines(), 10);
}

TEST(IlluminationMapPhotons, NameBlocksLampsAndColours)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto room = RoundRoom(12);
  vtkNew<vtkDoubleArray> red;
  red->SetName("DiffuseReflectance");
  red->SetNumberOfComponents(3);
  for (vtkIdType c = 0; c < room->GetNumberOfCells(); ++c)
  {
    red->InsertNextTuple3(0.6, 0.1, 0.1);
  }
  room->GetCellData()->AddArray(red);
  blocks->SetBlock(1, room);
  vtkNew<vtkPlaneSource> table;
  table->SetOrigin(-0.1, -0.1, -0.2);
  table->SetPoint1(0.1, -0.1, -0.2);
  table->SetPoint2(-0.1, 0.1, -0.2);
  table->Update();
  blocks->SetBlock(2, table->GetOutput());
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(blocks);
  map->AddLuminaireConnection(PointLamp(0.1, 0.0, 0.1, 100.0, "left")->GetOutputPort());
  map->AddLuminaireConnection(PointLamp(-0.1, 0.0, 0.1, 300.0, "right")->GetOutputPort());
  map->SetPhotons(20000);
  map->SetMaximumPhotons(Everything);
  map->SetPhotonPaths(200);
  map->Update();
  vtkPolyData* photons = Output(map, 2);
  EXPECT_EQ(FieldText(photons, "LuminaireNames"), "left\nright\n");
  double onTable = 0.0;
  double direct[2] = { 0.0, 0.0 };
  for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); ++i)
  {
    const double flux = PointArray(photons, "Flux")->GetTuple1(i);
    const int block = static_cast<int>(PointArray(photons, "BlockIndex")->GetTuple1(i));
    ASSERT_TRUE(block == 2 || block == 3) << "flat indices, as in messages";
    const bool below = photons->GetPoint(i)[2] < -0.19 && photons->GetPoint(i)[2] > -0.21 &&
      std::abs(photons->GetPoint(i)[0]) < 0.1001 && std::abs(photons->GetPoint(i)[1]) < 0.1001;
    EXPECT_EQ(block == 3, below);
    onTable += block == 3 ? flux : 0.0;
    double rgb[3];
    PointArray(photons, "FluxRGB")->GetTuple(i, rgb);
    EXPECT_NEAR(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2], flux, 1e-6 * flux);
    if (PointArray(photons, "Scatterings")->GetTuple1(i) == 0.0)
    {
      direct[static_cast<int>(PointArray(photons, "Luminaire")->GetTuple1(i))] += flux;
    }
  }
  EXPECT_GT(onTable, 0.0);
  EXPECT_NEAR(direct[0], 100.0, 2.0) << "each photon meets the closed room first";
  EXPECT_NEAR(direct[1], 300.0, 2.0);
  vtkPolyData* paths = Output(map, 3);
  ASSERT_EQ(paths->GetNumberOfLines(), 200);
  for (vtkIdType c = 0; c < 200; ++c)
  {
    const auto lamp = static_cast<int>(paths->GetCellData()->GetArray("Luminaire")->GetTuple1(c));
    double start[3];
    paths->GetPoint(paths->GetCell(c)->GetPointId(0), start);
    EXPECT_NEAR(start[0], lamp == 0 ? 0.1 : -0.1, 1e-5) << "a path begins at its lamp";
    EXPECT_EQ(paths->GetCellData()->GetArray("Escaped")->GetTuple1(c), 0.0);
  }
}

TEST(IlluminationMapPhotons, PathsThatLeaveTheSceneEndBeyondIt)
{
  const auto map = LitRoom(Ball(12), 0);
  map->SetLampType(vtkIlluminationMap::PARALLEL);
  map->SetPhotonPaths(100);
  map->Update();
  vtkPolyData* paths = Output(map, 3);
  ASSERT_EQ(paths->GetNumberOfLines(), 100);
  for (vtkIdType c = 0; c < 100; ++c)
  {
    vtkCell* path = paths->GetCell(c);
    const double absorbed = 1.0 - paths->GetCellData()->GetArray("Escaped")->GetTuple1(c);
    double end[3];
    paths->GetPoint(path->GetPointId(static_cast<int>(path->GetNumberOfPoints()) - 1), end);
    if (absorbed == 1.0)
    {
      EXPECT_LT(vtkMath::Norm(end), 0.501) << "on the ball";
    }
    else if (path->GetNumberOfPoints() > 2)
    {
      EXPECT_GT(vtkMath::Norm(end), 0.501) << "reflected, away from a convex body";
    }
  }
}

TEST(IlluminationMapPhotons, OfACurvedSurfaceNameTheInputsCells)
{
  const auto map = LitRoom(RoundRoom(12), Everything);
  map->SetCurvedSurface(true);
  map->Update();
  vtkPolyData* photons = Output(map, 2);
  ASSERT_GT(photons->GetNumberOfPoints(), 1000);
  vtkPolyData* room = map->GetOutput();
  for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); i += 37)
  {
    const auto cell = static_cast<vtkIdType>(PointArray(photons, "OriginalCellIds")->GetTuple1(i));
    ASSERT_TRUE(cell >= 0 && cell < room->GetNumberOfCells());
    double point[3];
    photons->GetPoint(i, point);
    EXPECT_NEAR(vtkMath::Norm(point), 0.498, 0.003) << "nearly on the sphere";
    double bounds[6];
    room->GetCellBounds(cell, bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GT(point[axis], bounds[2 * axis] - 0.05);
      EXPECT_LT(point[axis], bounds[2 * axis + 1] + 0.05);
    }
  }
}

TEST(IlluminationMapPhotons, BadNumbersAreNamed)
{
  const auto map = LitRoom(RoundRoom(12), -1);
  EXPECT_TRUE(Holds(ErrorOf(map), "MaximumPhotons is -1; it must be 0 or more"));
  map->SetMaximumPhotons(10);
  map->SetPhotonPaths(10001);
  EXPECT_TRUE(Holds(ErrorOf(map), "PhotonPaths is 10001; it must be from 0 to 10000"));
  EXPECT_EQ(Output(map, 2)->GetNumberOfPoints(), 0) << "and there are no photons";
  map->SetPhotonPaths(0);
  EXPECT_TRUE(ErrorOf(map).empty());
}
