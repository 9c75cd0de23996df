// SPDX-License-Identifier: BSD-3-Clause
// Light that a map does not show is explained by one warning, and by none where all is well.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkLuminaireSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <functional>

namespace
{

/// A closed room of 4 m by 4 m by 3 m, its corner at the origin.
vtkSmartPointer<vtkPolyData> Room(bool inward)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.0, 4.0, 0.0, 4.0, 0.0, 3.0);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(cube->GetOutputPort());
  normals->SetFlipNormals(inward);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> With(vtkPolyData* room, double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(radius);
  vtkNew<vtkAppendPolyData> all;
  all->AddInputData(room);
  all->AddInputConnection(ball->GetOutputPort());
  all->Update();
  return all->GetOutput();
}

vtkSmartPointer<vtkPolyData> Table()
{
  vtkNew<vtkPlaneSource> table;
  table->SetResolution(4, 4);
  table->Update();
  return table->GetOutput();
}

/// The room with one of its six faces, of 4 points each, facing the other way: 0 and 1 are walls, 4
/// is the floor.
vtkSmartPointer<vtkPolyData> RoomWithFaceTurned(int face)
{
  vtkSmartPointer<vtkPolyData> room = Room(true);
  vtkDataArray* normals = room->GetPointData()->GetNormals();
  for (vtkIdType point = 4 * face; point < 4 * face + 4; ++point)
  {
    double n[3];
    normals->GetTuple(point, n);
    normals->SetTuple3(point, -n[0], -n[1], -n[2]);
  }
  return room;
}

struct Case
{
  const char* name;
  vtkSmartPointer<vtkPolyData> surface;
  std::function<void(vtkIlluminationMap*)> set;
  const char* words; ///< Of the warning; none is expected where they are empty.
};

void Point(vtkIlluminationMap* map, double x, double y, double z)
{
  map->SetLampType(vtkIlluminationMap::POINT);
  map->SetLampPosition(x, y, z);
}

void Spot(vtkIlluminationMap* map, double z, double direction)
{
  map->SetLampType(vtkIlluminationMap::SPOT);
  map->SetLampPosition(2.0, 2.0, z);
  map->SetLampDirection(0.0, 0.0, direction);
}

std::vector<Case> Cases()
{
  using Map = vtkIlluminationMap;
  const auto inside = [](Map* map) { Point(map, 2.0, 2.0, 2.0); };
  const auto overTable = [](Map* map) { Point(map, 0.0, 0.0, 1.0); };
  const auto panelThroughCeiling = [](Map* map)
  {
    map->SetLampType(Map::RECTANGLE);
    map->SetLampPosition(2.0, 2.0, 2.95);
    map->SetLampDirection(0.25, 0.0, -1.0);
    map->SetLampSize(1.0, 1.0);
  };
  return {
    { "a lamp in a room", Room(true), inside, "" },
    { "a lamp in a room inside out", Room(false), inside, "fell on the backs of facets" },
    { "the same, backs registered", Room(false),
      [=](Map* map)
      {
        inside(map);
        map->RegisterBackSideOn();
      },
      "" },
    { "a lamp in mm", Room(true), [](Map* map) { Point(map, 2000.0, 2000.0, 2000.0); },
      "divided by 1000, as from millimetres to metres" },
    { "a lamp near the room", Room(true), [](Map* map) { Point(map, 2.0, 2.0, 5.0); },
      "fell on the backs of facets" },
    { "a spot above the ceiling", Room(true), [](Map* map) { Spot(map, 4.0, -1.0); },
      "fell on the backs of facets" },
    { "a spot that looks away", Room(true), [](Map* map) { Spot(map, 4.0, 1.0); },
      "left the scene without meeting it" },
    { "a lamp in a solid ball", With(Room(true), 2.0, 2.0, 2.0, 0.3), inside,
      "inside a solid body" },
    { "a lamp in a shade", With(Room(true), 2.0, 2.0, 2.0, 0.3),
      [=](Map* map)
      {
        inside(map);
        map->SetDiffuseTransmittance(0.4);
      },
      "" },
    { "a lamp in a ball of glass", With(Room(true), 2.0, 2.0, 2.0, 0.3),
      [=](Map* map)
      {
        inside(map);
        map->SetReflectance(0.0);
        map->SetClearTransmittance(0.9);
        map->SolidBodyOn();
      },
      "" },
    { "a ball beside the lamp", With(Room(true), 1.0, 1.0, 1.0, 0.3), inside, "" },
    { "a closed room by default", Room(true), [](Map*) {}, "If the surface is a closed room" },
    { "the outside of a box by default", Room(false), [](Map*) {}, "" },
    { "a table by default", Table(), [](Map*) {}, "" },
    { "a lamp over a table", Table(), overTable, "" },
    { "a lamp high over a table", Table(), [](Map* map) { Point(map, 0.0, 0.0, 2.0); }, "" },
    { "light on the ceiling above a floor that looks down", RoomWithFaceTurned(4),
      [](Map* map)
      {
        Spot(map, 1.0, 1.0);
        map->SetReflectance(0.8);
      },
      "of the scattered light that met the surface fell on backs" },
    { "a panel through the ceiling of a dark room", Room(true),
      [=](Map* map)
      {
        panelThroughCeiling(map);
        map->SetReflectance(0.0);
      },
      "of the lamp" },
    { "the same, in a room that scatters", Room(true), panelThroughCeiling, "of the lamp" },
    { "light along a table", Table(), [](Map* map) { map->SetLampDirection(1.0, 0.0, 0.0); },
      "met no facet" },
    { "a table from below", Table(), [](Map* map) { map->SetLampDirection(0.0, 0.0, 1.0); },
      "reached next to no front" },
    { "a target in the dark", Room(true),
      [](Map* map)
      {
        map->SetTargetRelativeError(0.01);
        map->SetPhotons(10000000000);
      },
      "TargetRelativeError can't be met" },
    { "a target on backs that are registered", Room(false),
      [=](Map* map)
      {
        inside(map);
        map->RegisterBackSideOn();
        map->SetTargetRelativeError(0.01);
        map->SetPhotons(1 << 24);
      },
      "" },
    { "a lamp of 0 lm", Room(true),
      [=](Map* map)
      {
        inside(map);
        map->SetLuminousFlux(0.0);
      },
      "" },
  };
}

void CheckFlux(vtkDataObject* output, const std::string& name)
{
  const double emitted = FieldValue(output, "EmittedFlux");
  const double arrived = FieldValue(output, "FluxOnFronts") + FieldValue(output, "FluxOnBacks") +
    FieldValue(output, "FluxEscaped");
  EXPECT_LE(arrived, emitted * (1.0 + 1e-12)) << name << ": no more arrives than is emitted";
  const bool opaque = FieldText(output, "Effects").find("transmission: on") == std::string::npos &&
    FieldText(output, "Effects").find("refraction: on") == std::string::npos;
  EXPECT_TRUE(!opaque || std::fabs(arrived - emitted) <= 1e-12 * emitted)
    << name << ": all is told";
}

} // namespace

TEST(IlluminationMapMissingLight, OneWarningExplainsIt)
{
  for (const Case& c : Cases())
  {
    vtkNew<vtkIlluminationMap> map;
    const CaughtMessages messages;
    map->SetInputData(c.surface);
    map->SetPhotons(20000);
    c.set(map);
    map->Update();
    const std::string words = c.words;
    const std::string name = c.name;
    EXPECT_EQ(messages->Errors, 0) << name << ": " << messages->Text;
    EXPECT_EQ(messages->Warnings, words.empty() ? 0 : 1) << name << ": " << messages->Text;
    EXPECT_TRUE(Holds(messages->Text, words)) << name;
    CheckFlux(map->GetOutput(), name);
    if (name == "a target in the dark")
    {
      EXPECT_EQ(FieldText(map->GetOutput(), "StoppedBy").find("nothing lit"), 0u) << name;
    }
    if (name == "a target on backs that are registered")
    {
      EXPECT_EQ(FieldText(map->GetOutput(), "StoppedBy").find("target relative error"), 0u)
        << FieldText(map->GetOutput(), "StoppedBy");
    }
    if (name == "a lamp of 0 lm")
    {
      EXPECT_TRUE(Holds(FieldText(map->GetOutput(), "Notes"), "0 lm")) << name;
    }
  }
}

// The lamp that most light is missing of is named.
TEST(IlluminationMapMissingLight, LampOfMostMissingLightIsNamed)
{
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(Room(true));
  vtkNew<vtkLuminaireSource> lamps[2];
  for (int i = 0; i < 2; ++i)
  {
    lamps[i]->SetType(vtkLuminaireSource::POINT);
    lamps[i]->SetPosition(2.0, 2.0, i == 0 ? 2.0 : 3.5);
    lamps[i]->SetLuminaireName(i == 0 ? "inside" : "above");
    map->AddLuminaireConnection(lamps[i]->GetOutputPort());
  }
  const CaughtMessages messages;
  map->Update();
  EXPECT_EQ(messages->Warnings, 1) << "one warning for two lamps";
  EXPECT_TRUE(Holds(messages->Text, "luminaire 'above'")) << "the lamp is named";
  EXPECT_FALSE(Holds(messages->Text, "'inside'")) << "the other one is not";
  EXPECT_TRUE(Holds(messages->Text, "of cell 5")) << "a cell is named";
}

// A ball that is inside out takes 9.5 % of a lamp's light, which is no reason for a warning, though
// the 2048 photons of many runs tell more than 10 %. Where it takes 15 % all runs warn.
TEST(IlluminationMapMissingLight, FewPhotonsAreNoReason)
{
  const auto turnedBall = [](double radius)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(2.0, 2.0, 1.0);
    ball->SetRadius(radius);
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(32);
    vtkNew<vtkReverseSense> turned;
    turned->SetInputConnection(ball->GetOutputPort());
    turned->ReverseNormalsOn();
    vtkNew<vtkAppendPolyData> all;
    all->AddInputData(Room(true));
    all->AddInputConnection(turned->GetOutputPort());
    all->Update();
    return vtkSmartPointer<vtkPolyData>(all->GetOutput());
  };
  const auto run = [](vtkPolyData* surface, int seed, int photons, double& share)
  {
    vtkNew<vtkIlluminationMap> map;
    const CaughtMessages messages;
    map->SetInputData(surface);
    map->SetPhotons(photons);
    map->SetReflectance(0.0);
    map->SetSampling(vtkIlluminationMap::RANDOM);
    map->SetSeed(seed);
    Point(map, 2.0, 2.0, 2.0);
    map->Update();
    share =
      FieldValue(map->GetOutput(), "FluxOnBacks") / FieldValue(map->GetOutput(), "EmittedFlux");
    return messages->Warnings;
  };
  const vtkSmartPointer<vtkPolyData> small = turnedBall(0.588), large = turnedBall(0.716);
  double share = 0.0;
  run(small, 1, 1 << 20, share);
  EXPECT_NEAR(share, 0.095, 0.001);
  run(large, 1, 1 << 20, share);
  EXPECT_NEAR(share, 0.15, 0.001);
  int tellMore = 0;
  for (int seed = 1; seed <= 40; ++seed)
  {
    EXPECT_EQ(run(small, seed, 2048, share), 0) << seed;
    tellMore += share > 0.1 ? 1 : 0;
    EXPECT_EQ(run(large, seed, 2048, share), 1) << seed;
  }
  EXPECT_GT(tellMore, 0);
}
