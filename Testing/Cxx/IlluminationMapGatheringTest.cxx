// SPDX-License-Identifier: BSD-3-Clause
// The second pass as the filter shows it: arrays, table and words; parts that add up; the same bits
// for any threads and any division of a run; what an abort and a time limit leave.
#include "GatheringTools.h"
#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

const char* const Maps[] = { "Illuminance", "IlluminanceDirect", "IlluminanceIndirect",
  "IlluminanceCaustic", "StandardError", "RelativeError" };

void ExpectComplete(vtkPolyData* output)
{
  for (const char* name : Maps)
  {
    vtkDataArray* array = PointArray(output, name);
    ASSERT_TRUE(array && array->GetNumberOfTuples() == output->GetNumberOfPoints()) << name;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      ASSERT_TRUE(std::isfinite(array->GetTuple1(i)) && array->GetTuple1(i) >= 0.0)
        << name << " " << i;
    }
  }
}

void ExpectSameMaps(vtkPolyData* a, vtkPolyData* b)
{
  for (const char* name : Maps)
  {
    EXPECT_TRUE(SameValues(PointArray(a, name), PointArray(b, name))) << name;
  }
}

/// The same filter, run for the first time.
vtkSmartPointer<vtkPolyData> InOneGo(vtkIlluminationMap* like, vtkPolyData* surface)
{
  vtkSmartPointer<vtkIlluminationMap> once = Gathering(surface, like->GetPhotons());
  once->SetSpecularReflectance(like->GetSpecularReflectance());
  once->SetGatherRays(like->GetGatherRays());
  once->Update();
  return once->GetOutput();
}

double LastRow(vtkIlluminationMap* filter, const char* column)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  return table->GetValueByName(table->GetNumberOfRows() - 1, column).ToDouble();
}

/// Aborts at the first event of the second pass.
void AbortWhileGathering(vtkObject* caller, unsigned long, void* seen, void*)
{
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  const std::string text = filter->GetProgressText() ? filter->GetProgressText() : "";
  if (text.rfind("Gathering light, ", 0) == 0)
  {
    *static_cast<bool*>(seen) = true;
    filter->SetAbortExecute(1);
  }
}

} // namespace

TEST(IlluminationMapGathering, ArraysTableAndWords)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(12);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 20000);
  filter->SetSpecularReflectance(0.3); // for caustics
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ExpectComplete(output);
  EXPECT_FALSE(PointArray(output, "PhotonHits")) << "they would tell of caustics alone";
  double caustics = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto at = [&](const char* name) { return PointArray(output, name)->GetTuple1(i); };
    EXPECT_EQ(at("Illuminance"), at("IlluminanceDirect") + at("IlluminanceIndirect"));
    EXPECT_LE(at("IlluminanceCaustic"), at("IlluminanceIndirect"));
    caustics += at("IlluminanceCaustic");
  }
  EXPECT_GT(caustics, 0.0);
  const double rays = LastRow(filter, "GatherRays");
  EXPECT_GE(rays, 16.0);
  EXPECT_TRUE(Holds(FieldText(output, "Effects"),
    "final gathering: on, about " + std::to_string(std::lround(rays)) + " rays for each of " +
      std::to_string(output->GetNumberOfPoints()) + " points"));
  EXPECT_TRUE(Holds(FieldText(output, "Effects"), "it concerns caustics alone"));

  filter->SetMethod(vtkIlluminationMap::PHOTON_TRACING);
  filter->Update();
  EXPECT_EQ(LastRow(filter, "GatherRays"), 0.0);
  EXPECT_TRUE(PointArray(filter->GetOutput(), "PhotonHits"));
  EXPECT_FALSE(PointArray(filter->GetOutput(), "IlluminanceCaustic"));
  EXPECT_TRUE(Holds(FieldText(filter->GetOutput(), "Effects"), "final gathering: off, Method is"));
}

TEST(IlluminationMapGathering, HasNoGroupMeans)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(8);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 5000);
  filter->Update();
  const double need = FieldValue(filter->GetOutput(), "MemoryNeeded");
  EXPECT_FALSE(PointArray(filter->GetOutput(), "IlluminanceDirectGroups"));
  filter->GroupMeansOff();
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "MemoryNeeded"), need);
}

TEST(IlluminationMapGathering, LampsAndColoursAddUp)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(12);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 20000);
  filter->SetSpecularReflectance(0.2);
  filter->LampContributionsOn();
  vtkSmartPointer<vtkLuminaireSource> red = PointLamp(0.2, 0.0, 0.1, 300.0, "Red");
  red->SetLightColour(1.0, 0.2, 0.1);
  vtkSmartPointer<vtkLuminaireSource> white = PointLamp(-0.2, 0.1, 0.0, 700.0, "White");
  filter->AddLuminaireConnection(red->GetOutputPort());
  filter->AddLuminaireConnection(white->GetOutputPort());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ExpectComplete(output);
  // What leaves a cell is kept in single precision, once for all lamps together and once by lamp.
  // On the way to a sum either takes a few roundings of 2^-24, all of one sign at worst.
  constexpr double Rounding = 4.0 * 0x1p-24;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto at = [&](const char* name, int c = 0)
    { return PointArray(output, name)->GetComponent(i, c); };
    const double total = at("Illuminance");
    EXPECT_NEAR(at("Illuminance_Red") + at("Illuminance_White"), total, Rounding * total) << i;
    EXPECT_NEAR(0.2126 * at("IlluminanceRGB", 0) + 0.7152 * at("IlluminanceRGB", 1) +
        0.0722 * at("IlluminanceRGB", 2),
      total, Rounding * total)
      << i;
    EXPECT_GT(at("IlluminanceRGB", 0), at("IlluminanceRGB", 1)) << "the light is reddish";
  }
}

// The back of a ball is a room: it has the light of the same room seen from inside.
TEST(IlluminationMapGathering, BacksAreLitAsFrontsAre)
{
  vtkSmartPointer<vtkPolyData> ball = Ball(16);
  vtkSmartPointer<vtkPolyData> room = RoundRoom(16);
  vtkSmartPointer<vtkIlluminationMap> onBacks = Gathering(ball, 50000);
  onBacks->RegisterBackSideOn();
  onBacks->Update();
  vtkSmartPointer<vtkIlluminationMap> onFronts = Gathering(room, 50000);
  onFronts->Update();
  const vtkIdType points = ball->GetNumberOfPoints();
  double squares = 0.0;
  for (vtkIdType i = 0; i < points; ++i)
  {
    const auto back = [&](const char* name)
    { return PointArray(onBacks->GetOutput(), name)->GetTuple1(i); };
    const auto front = [&](const char* name)
    { return PointArray(onFronts->GetOutput(), name)->GetTuple1(i); };
    EXPECT_EQ(back("Illuminance"), 0.0) << "it is dark outside";
    const double error = std::hypot(back("StandardErrorBack"), front("StandardError"));
    squares += std::pow((back("IlluminanceBack") - front("Illuminance")) / error, 2.0);
  }
  // Student's t with 7 degrees of freedom has the variance 7/5. Noise of the first pass is shared
  // by neighbours, so that the mean has itself a spread.
  EXPECT_LT(squares / static_cast<double>(points), 2.0 * 7.0 / 5.0);
}

TEST(IlluminationMapGathering, SameBitsForAnyThreadsAndWhenGoingOn)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(12);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 10000);
  filter->SetSpecularReflectance(0.3);
  filter->Update();
  const double before = FieldValue(filter->GetOutput(), "Seconds");
  filter->SetPhotons(30000);
  filter->Update();
  EXPECT_GT(FieldValue(filter->GetOutput(), "Seconds"), before) << "it went on: time adds up";
  vtkSmartPointer<vtkPolyData> once = InOneGo(filter, room);
  ExpectSameMaps(filter->GetOutput(), once);
  for (const int threads : { 1, 2, 3 })
  {
    filter->SetNumberOfThreads(threads); // anew
    filter->Update();
    SCOPED_TRACE(threads);
    ExpectSameMaps(filter->GetOutput(), once);
  }
}

TEST(IlluminationMapGathering, AnAbortLeavesAMapAndTheRunGoesOn)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(32);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 20000);
  filter->SetSpecularReflectance(0.3);
  filter->SetNumberOfThreads(1);
  filter->SetGatherRays(1024); // progress is told every 50 ms, within which few rays are done
  bool seen = false;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(AbortWhileGathering);
  observer->SetClientData(&seen);
  const auto tag = filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  EXPECT_TRUE(seen) << "the text says that light is gathered";
  EXPECT_EQ(FieldText(filter->GetOutput(), "StoppedBy"), "abort\n");
  ExpectComplete(filter->GetOutput());
  const double emitted = FieldValue(filter->GetOutput(), "PhotonsEmitted");
  EXPECT_EQ(emitted, 20480.0) << "all photons were traced before";
  vtkSmartPointer<vtkPolyData> once = InOneGo(filter, room);
  EXPECT_FALSE(
    SameValues(PointArray(filter->GetOutput(), "Illuminance"), PointArray(once, "Illuminance")))
    << "it was stopped before the end";

  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  const double before = FieldValue(filter->GetOutput(), "Seconds");
  filter->SetTimeLimit(1e6); // another execution of the same run
  filter->Update();
  EXPECT_EQ(FieldText(filter->GetOutput(), "StoppedBy"), "photon limit\n");
  EXPECT_EQ(FieldValue(filter->GetOutput(), "PhotonsEmitted"), emitted);
  EXPECT_GT(FieldValue(filter->GetOutput(), "Seconds"), before) << "time adds up";
  ExpectSameMaps(filter->GetOutput(), once);
}

TEST(IlluminationMapGathering, ATimeLimitLeavesAMapAndTheRunGoesOn)
{
  vtkSmartPointer<vtkPolyData> room = RoundRoom(24);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(room, 1000000);
  filter->SetTimeLimit(1e-9);
  filter->Update();
  EXPECT_EQ(FieldText(filter->GetOutput(), "StoppedBy"), "time limit\n");
  ExpectComplete(filter->GetOutput());
  filter->SetTimeLimit(0.0);
  filter->SetPhotons(100000);
  filter->Update();
  EXPECT_EQ(FieldText(filter->GetOutput(), "StoppedBy"), "photon limit\n");
  ExpectSameMaps(filter->GetOutput(), InOneGo(filter, room));
}

// Half a ball under a uniform sky. Each part of a ball sends the same light to every other, in
// proportion to its area. So the sky, in place of the missing half, gives every point half of what
// open ground gets, E_0 / 2, and E = E_0 / 2 + rho E / 2 = 2/3 E_0 for a reflectance of 1/2.
TEST(IlluminationMapGathering, ABowlUnderASkyIsLitEvenly)
{
  constexpr double OpenGround = 900.0; // lx
  constexpr int Resolution = 48;
  vtkNew<vtkLuminaireSource> sky;
  sky->SetType(vtkLuminaireSource::UNIFORM_SKY);
  sky->SetIlluminance(OpenGround);
  vtkSmartPointer<vtkPolyData> bowl = RoundRoom(Resolution, 90.0);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(bowl, 4096); // too few: cells are linked
  filter->SetGatherRays(256);
  filter->SetReflectance(0.5);
  filter->AddLuminaireConnection(sky->GetOutputPort());
  filter->Update();
  ExpectComplete(filter->GetOutput());
  double sum = 0.0, variance = 0.0;
  const auto points = static_cast<double>(bowl->GetNumberOfPoints());
  for (vtkIdType i = 0; i < bowl->GetNumberOfPoints(); ++i)
  {
    sum += PointArray(filter->GetOutput(), "Illuminance")->GetTuple1(i);
    variance += std::pow(PointArray(filter->GetOutput(), "StandardError")->GetTuple1(i), 2.0);
  }
  const double expected = 2.0 / 3.0 * OpenGround;
  // Chords of facets lie within the ball by (turn)^2 / 8 of its radius, which is the order of the
  // area and of the solid angles that they miss.
  const double turn = 2.0 * 3.14159265358979 / Resolution;
  EXPECT_NEAR(
    sum / points, expected, 3.0 * std::sqrt(variance) / points + turn * turn / 4.0 * expected);
}

// The first pass counts photons on both sides of cells, whichever side the map is of.
TEST(IlluminationMapGathering, LightOnBacksAloneIsNoLight)
{
  CaughtMessages messages;
  vtkSmartPointer<vtkPolyData> ball = Ball(8);
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(ball, 4000000);
  filter->SetTargetRelativeError(0.05);
  filter->SetGatherRays(16);
  filter->Update();
  EXPECT_EQ(messages->Errors, 0) << messages->Text;
  ExpectComplete(filter->GetOutput());
  EXPECT_TRUE(Holds(FieldText(filter->GetOutput(), "StoppedBy"), "nothing lit"));
}
