// SPDX-License-Identifier: BSD-3-Clause
// Maps that are refined while a window shows them.
#include "GatheringTools.h"
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

namespace
{

constexpr vtkIdType Photons = 600000;
constexpr double FirstPicture = 65536;

vtkSmartPointer<vtkIlluminationMap> MapOf(vtkPolyData* surface, vtkIdType photons)
{
  auto map = vtkSmartPointer<vtkIlluminationMap>::New();
  map->SetInputData(surface);
  map->SetPhotons(photons);
  return map;
}

/// A room, whose photons take some time.
vtkSmartPointer<vtkPolyData> Room()
{
  return RoundRoom(12);
}

vtkSmartPointer<vtkIlluminationMap> InRoom(vtkIdType photons)
{
  auto map = MapOf(Room(), photons);
  map->SetLampType(vtkIlluminationMap::POINT);
  map->SetLampPosition(0.1, 0.0, 0.0);
  return map;
}

double PhotonsOf(vtkIlluminationMap* map)
{
  return FieldValue(map->GetOutput(), "PhotonsEmitted");
}

/// Of the illuminance, over points.
double MeanOf(vtkIlluminationMap* map)
{
  vtkDataArray* lux = PointArray(map->GetOutput(), "Illuminance");
  double sum = 0.0;
  for (vtkIdType p = 0; p < lux->GetNumberOfTuples(); ++p)
  {
    sum += lux->GetTuple1(p);
  }
  return sum / static_cast<double>(lux->GetNumberOfTuples());
}

bool IsPreliminary(vtkIlluminationMap* map)
{
  return Holds(FieldText(map->GetOutput(), "Notes"), "preliminary");
}

bool GoesOn(vtkIlluminationMap* map)
{
  return Holds(FieldText(map->GetOutput(), "StoppedBy"), "goes on");
}

/// As a window does, until there is a better map. @return Whether there was one in time.
bool WaitForNews(vtkIlluminationMap* map)
{
  const auto begin = std::chrono::steady_clock::now();
  while (!map->GetNeedsUpdate())
  {
    if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(60))
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

class Progress : public ::testing::TestWithParam<int>
{
protected:
  vtkSmartPointer<vtkIlluminationMap> Watched(vtkIdType photons) const
  {
    auto map = InRoom(photons);
    map->SetMethod(GetParam());
    map->SetGatherRays(GetParam() == vtkIlluminationMap::FINAL_GATHERING ? 16 : 0);
    EXPECT_FALSE(map->GetNeedsUpdate()) << "nothing has run";
    return map;
  }
};

} // namespace

TEST_P(Progress, MapsGetBetterUntilTheLastHasTheBitsOfOneRun)
{
  const bool gathers = GetParam() == vtkIlluminationMap::FINAL_GATHERING;
  auto map = Watched(Photons);
  map->Update();
  EXPECT_EQ(IsPreliminary(map), gathers);
  std::vector<double> shown{ PhotonsOf(map) };
  EXPECT_GE(shown[0], FirstPicture);
  EXPECT_LT(shown[0], 1.1 * FirstPicture);
  while (GoesOn(map))
  {
    ASSERT_TRUE(WaitForNews(map));
    map->Update();
    EXPECT_FALSE(IsPreliminary(map));
    shown.push_back(PhotonsOf(map));
    const bool samePhotons = gathers && shown.size() == 2;
    const double before = shown[shown.size() - 2];
    const double wanted = samePhotons ? before : std::min(2.0 * before, double{ Photons });
    EXPECT_GE(shown.back(), wanted);
    EXPECT_LT(shown.back(), wanted + 8 * 256);
  }
  EXPECT_EQ(shown.size(), gathers ? 6u : 5u); // 65, 131, 262, 524 and 600 thousand
  EXPECT_FALSE(map->GetNeedsUpdate()) << "nothing more to come";
  auto atOnce = InRoom(Photons);
  atOnce->SetMethod(map->GetMethod());
  atOnce->SetGatherRays(map->GetGatherRays());
  atOnce->Update();
  for (const char* array : { "Illuminance", "StandardError" })
  {
    EXPECT_TRUE(
      SameValues(PointArray(map->GetOutput(), array), PointArray(atOnce->GetOutput(), array)))
      << array;
  }
}

// The first map by Final Gathering is that of the photons. It is rough, and tells an error as large
// as its light.
TEST(IlluminationMapProgress, TheFirstMapByFinalGatheringIsThatOfThePhotons)
{
  auto map = InRoom(1000); // fewer than for a first picture
  map->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  map->GetNeedsUpdate();
  map->Update();
  EXPECT_TRUE(GoesOn(map));
  ASSERT_TRUE(IsPreliminary(map));
  const double first = MeanOf(map);
  EXPECT_TRUE(SameValues(
    PointArray(map->GetOutput(), "Illuminance"), PointArray(map->GetOutput(), "StandardError")));
  while (GoesOn(map))
  {
    ASSERT_TRUE(WaitForNews(map));
    map->Update();
  }
  EXPECT_FALSE(IsPreliminary(map));
  // Means of all light by some thousand photons, over points in place of areas.
  EXPECT_NEAR(first / MeanOf(map), 1.0, 0.1);
}

TEST_P(Progress, EveryMapHasTheBitsOfARunToItsPhotons)
{
  auto map = Watched(Photons);
  map->Update();
  ASSERT_TRUE(WaitForNews(map));
  map->Update();
  ASSERT_TRUE(GoesOn(map));
  auto atOnce = InRoom(static_cast<vtkIdType>(PhotonsOf(map)));
  atOnce->SetMethod(map->GetMethod());
  atOnce->SetGatherRays(map->GetGatherRays());
  atOnce->Update();
  EXPECT_TRUE(SameValues(
    PointArray(map->GetOutput(), "Illuminance"), PointArray(atOnce->GetOutput(), "Illuminance")));
}

TEST_P(Progress, ChangesStartAnewOrGoOnAtOnce)
{
  auto map = Watched(100'000'000);
  map->Update();
  map->SetReflectance(0.3); // another map
  map->Update();
  EXPECT_TRUE(GoesOn(map));
  EXPECT_LT(PhotonsOf(map), 1.1 * FirstPicture);
  map->SetTimeLimit(1000.0); // the same map
  map->Update();
  EXPECT_TRUE(GoesOn(map));
  EXPECT_GE(PhotonsOf(map), FirstPicture);
  map->SetProgressive(false);
  map->SetPhotons(static_cast<vtkIdType>(4.0 * PhotonsOf(map)));
  const double wanted = static_cast<double>(map->GetPhotons());
  map->Update();
  EXPECT_FALSE(GoesOn(map));
  EXPECT_GE(PhotonsOf(map), wanted);
  EXPECT_FALSE(map->GetNeedsUpdate());
}

TEST_P(Progress, AFilterMayEndWhileItsRunGoesOn)
{
  auto map = Watched(100'000'000);
  map->Update();
  EXPECT_TRUE(GoesOn(map));
}

INSTANTIATE_TEST_SUITE_P(IlluminationMap, Progress,
  ::testing::Values(vtkIlluminationMap::PHOTON_TRACING, vtkIlluminationMap::FINAL_GATHERING));

TEST(IlluminationMapProgress, WithoutAWindowThereIsTheLastMapAlone)
{
  auto map = InRoom(Photons);
  map->Update();
  EXPECT_FALSE(GoesOn(map));
  EXPECT_GE(PhotonsOf(map), Photons);
}

TEST(IlluminationMapProgress, ATargetEndsItAndWarningsComeOnceAtTheEnd)
{
  vtkNew<vtkPlaneSource> plane; // which looks up, away from its light
  plane->SetResolution(4, 4);
  plane->Update();
  auto map = MapOf(plane->GetOutput(), Photons);
  map->SetLampDirection(0.0, 0.0, 1.0);
  CaughtMessages messages;
  map->GetNeedsUpdate();
  map->Update();
  EXPECT_TRUE(GoesOn(map));
  EXPECT_EQ(messages->Warnings, 0);
  while (GoesOn(map))
  {
    ASSERT_TRUE(WaitForNews(map));
    map->Update();
  }
  EXPECT_EQ(messages->Warnings, 1);

  auto towards = InRoom(1'000'000'000);
  towards->SetTargetRelativeError(0.02);
  towards->GetNeedsUpdate();
  towards->Update();
  while (GoesOn(towards))
  {
    ASSERT_TRUE(WaitForNews(towards));
    towards->Update();
  }
  EXPECT_TRUE(Holds(FieldText(towards->GetOutput(), "StoppedBy"), "target"));
}

// While nobody asks it takes no time of the processor, and then it goes on.
TEST(IlluminationMapProgress, ItPausesWhileNobodyAsks)
{
  auto map = InRoom(3'000'000); // some seconds, so that twice as many take longer than it waits
  map->SetNumberOfThreads(1);
  map->Update();
  map->GetNeedsUpdate();
  map->SetPhotons(1'000'000'000);
  map->Update();
  ASSERT_TRUE(GoesOn(map));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  const std::clock_t begin = std::clock(); // of all threads
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 0.1);
  ASSERT_TRUE(WaitForNews(map));
  map->Update();
  EXPECT_GE(PhotonsOf(map), 6'000'000);
}

// An error of the settings is told once, and nothing goes on behind it.
TEST(IlluminationMapProgress, AnErrorEndsTheRun)
{
  auto map = InRoom(100'000'000);
  CaughtMessages messages;
  map->GetNeedsUpdate();
  map->Update();
  ASSERT_TRUE(GoesOn(map));
  map->SetTargetRelativeError(-1.0);
  map->Update();
  EXPECT_EQ(messages->Errors, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_FALSE(map->GetNeedsUpdate());
}
