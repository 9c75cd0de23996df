// SPDX-License-Identifier: BSD-3-Clause
// What a run takes: told before, not exceeded, refused where it is too much, and given back.
#include "FilterTools.h"
#include "ProcessMemory.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/MemoryLimit.h"

#include "vtkLuminaireSource.h"

#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

using namespace ProcessMemory;

namespace
{

#if defined(__SANITIZE_ADDRESS__)
/// It keeps freed memory for a while, and looks for leaks by itself.
constexpr bool MeasuresMemory = false;
#else
constexpr bool MeasuresMemory = true;
#endif

class FilterMemory : public FilterTest
{
protected:
  FilterMemory()
    : FilterTest("a run that the system ends for want of memory; memory that is not given back")
  {
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    if (Status("VmRSS:") == 0.0)
    {
      GTEST_SKIP() << "this system does not tell what a process takes";
    }
  }

  double Needed() const { return FieldValue(this->Filter->GetOutput(), "MemoryNeeded"); }

  /// The run on a surface takes no more than it said, and no less than a share of that.
  void ExpectTaken(vtkPolyData* surface, double least)
  {
    this->Filter->SetInputData(SmallSphere());
    this->ExpectMap(); // what every process takes: libraries, threads
    GiveBack();
    const double before = Status("VmRSS:");
    ForgetPeak();
    this->Filter->SetInputData(surface);
    this->ExpectMap();
    const double taken = Status("VmHWM:") - before;
    // Without the numbers, which differ from run to run: the table shall not.
    this->Measured("between " + std::to_string(std::lround(100.0 * least)) +
      " % and all of what it said was taken");
    // VTK's own cutting and copying comes before, and is no more than this run.
    EXPECT_LT(taken, this->Needed());
    EXPECT_GT(taken, least * this->Needed()) << "it would refuse what could be run";
  }
};

/// The lower half of a ball as a bowl that is open to the sky, 128 thousand triangles. There are
/// few around the rim, which is an opening: each edge of an opening takes time.
vtkSmartPointer<vtkPolyData> LargeBowl()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(1000);
  sphere->SetStartPhi(90.0);
  vtkNew<vtkReverseSense> inside;
  inside->SetInputConnection(sphere->GetOutputPort());
  inside->ReverseCellsOn();
  inside->ReverseNormalsOn();
  inside->Update();
  return inside->GetOutput();
}

/// 1000 x 500 points and nearly a million triangles, or fewer.
vtkSmartPointer<vtkPolyData> LargeSphere(int around = 1000, int along = 500)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(around);
  sphere->SetPhiResolution(along);
  sphere->Update();
  return sphere->GetOutput();
}

void Gather(vtkIlluminationMap* filter)
{
  filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  filter->SetGatherRays(16);
}

/// Four lamps, which are kept apart, one of them coloured.
void AddLamps(vtkIlluminationMap* filter)
{
  filter->SetLampContributions(true);
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkLuminaireSource> lamp;
    lamp->SetType(vtkLuminaireSource::POINT);
    lamp->SetPosition(0.05 * i, 0.1, -0.1);
    lamp->SetLightColour(1.0, i == 0 ? 0.5 : 1.0, 1.0);
    filter->AddLuminaireConnection(lamp->GetOutputPort());
  }
}

/// What a run may have in addition.
struct Kind
{
  const char* name;
  std::function<void(vtkIlluminationMap*)> set;
  double least = 0.8; ///< Share of what it said that it takes.
};

const Kind Kinds[] = {
  { "EightThreadsWithoutGroupMeans",
    [](vtkIlluminationMap* filter)
    {
      filter->SetNumberOfThreads(8);
      filter->SetGroupMeans(false);
    } },
  { "LampsApartInColours", AddLamps },
  { "PhotonMap",
    [](vtkIlluminationMap* filter)
    {
      filter->SetPhotons(300'000);
      filter->SetMaximumPhotons(500'000);
    } },
  { "CurvedPatches", [](vtkIlluminationMap* filter) { filter->SetCurvedSurface(true); } },
  { "Gathered", Gather },
  { "GatheredLampsApartInColours",
    [](vtkIlluminationMap* filter)
    {
      Gather(filter);
      AddLamps(filter);
    } },
  { "GatheredAndRefined",
    [](vtkIlluminationMap* filter)
    {
      Gather(filter);
      filter->SetAdaptiveRefinement(true);
    },
    0.7 }, // at how many middles of edges there is light is not counted
};

class FilterMemoryOfKinds
  : public FilterMemory
  , public ::testing::WithParamInterface<Kind>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Stability, FilterMemoryOfKinds, ::testing::ValuesIn(Kinds),
  [](const ::testing::TestParamInfo<Kind>& instance) { return instance.param.name; });

TEST_F(FilterMemory, NoMoreThanWasSaid)
{
  if (!MeasuresMemory)
  {
    GTEST_SKIP() << "not with the address sanitizer";
  }
  vtkSmartPointer<vtkPolyData> large = LargeSphere();
  struct Case
  {
    int lamp, threads;
    bool back;
  };
  for (const Case& c :
    { Case{ vtkIlluminationMap::PARALLEL, 1, false }, Case{ vtkIlluminationMap::POINT, 8, true } })
  {
    this->Filter->SetLampType(c.lamp);
    this->Filter->SetNumberOfThreads(c.threads);
    this->Filter->SetRegisterBackSide(c.back);
    this->ExpectTaken(large, 0.8);
  }
}

TEST_P(FilterMemoryOfKinds, NoMoreThanWasSaid)
{
  if (!MeasuresMemory)
  {
    GTEST_SKIP() << "not with the address sanitizer";
  }
  this->LightMayBeMissing = true;
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  this->Filter->SetLampPosition(0.05, 0.1, -0.1);
  this->Filter->SetNumberOfThreads(2);
  GetParam().set(this->Filter);
  this->ExpectTaken(LargeSphere(400, 250), GetParam().least);
}

// The second pass; and under a sky the links of its first pass.
TEST_F(FilterMemory, NoMoreThanWasSaidWithFinalGathering)
{
  if (!MeasuresMemory)
  {
    GTEST_SKIP() << "not with the address sanitizer";
  }
  this->LightMayBeMissing = true;
  this->Filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  vtkNew<vtkLuminaireSource> sky;
  sky->SetType(vtkLuminaireSource::UNIFORM_SKY);
  vtkSmartPointer<vtkPolyData> sphere = LargeSphere();
  vtkSmartPointer<vtkPolyData> bowl = LargeBowl();
  for (const bool underSky : { false, true })
  {
    SCOPED_TRACE(underSky);
    this->Filter->SetNumberOfThreads(underSky ? 2 : 8);
    this->Filter->SetRegisterBackSide(!underSky);
    if (underSky)
    {
      this->Filter->AddLuminaireConnection(sky->GetOutputPort());
    }
    this->ExpectTaken(underSky ? bowl : sphere, 0.8);
  }
}

TEST_F(FilterMemory, MoreThanTheLimitIsRefused)
{
  this->ExpectMap();
  const double needed = this->Needed();
  EXPECT_GT(needed, 0.0);
  this->Filter->SetSeed(2); // another run, so that none is at hand to go on from
  this->Filter->SetMemoryLimit(0.99 * needed * 0x1p-30);
  this->ExpectError("and its limit is ");
  this->Filter->SetMemoryLimit(1e-300);
  this->ExpectError("and its limit is 9.31e-10 GiB");
  this->Filter->SetMemoryLimit(1.01 * needed * 0x1p-30);
  this->ExpectMap();
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), -1.0, std::numeric_limits<double>::infinity() })
  {
    this->Filter->SetMemoryLimit(bad);
    this->ExpectError("MemoryLimit is ");
  }
  this->Filter->SetMemoryLimit(1e300);
  this->ExpectMap();
}

// Links between cells are known only once they are found.
TEST_F(FilterMemory, MoreThanTheLimitIsRefusedUnderASky)
{
  this->LightMayBeMissing = true;
  Gather(this->Filter);
  vtkNew<vtkLuminaireSource> sky;
  sky->SetType(vtkLuminaireSource::UNIFORM_SKY);
  this->Filter->AddLuminaireConnection(sky->GetOutputPort());
  this->ExpectMap();
  const double needed = this->Needed();
  this->Filter->SetSeed(2); // another run, with nearly as many links
  this->Filter->SetMemoryLimit(0.9 * needed * 0x1p-30);
  this->ExpectError("and its limit is ");
  this->Filter->SetMemoryLimit(1.1 * needed * 0x1p-30);
  this->ExpectMap();
}

// A run that was made with less memory does not go on from its coarser patches.
TEST_F(FilterMemory, CurvedPatchesAreAsFineAsTheLimitAllows)
{
  vtkNew<vtkSphereSource> sphere;
  this->Filter->SetInputConnection(sphere->GetOutputPort());
  this->Filter->SetCurvedSurface(true);
  this->ExpectMap();
  const double fine = this->Needed();
  this->Filter->SetSeed(2); // another run
  this->Filter->SetMemoryLimit(0.5 * fine * 0x1p-30);
  this->ExpectMap();
  EXPECT_LT(this->Needed(), 0.5 * fine);
  this->Filter->SetMemoryLimit(0.0);
  this->ExpectMap();
  EXPECT_EQ(this->Needed(), fine);
}

TEST_F(FilterMemory, MoreThanTheMachineHasIsRefused)
{
  const std::optional<std::uint64_t> available = PhotonTransport::AvailableMemory();
  ASSERT_TRUE(available);
  EXPECT_GT(*available, 0u);
  using PhotonTransport::InvalidInput;
  const PhotonTransport::MemoryLimit whatThereIs;
  EXPECT_NO_THROW(whatThereIs.Require(*available / 2));
  EXPECT_THROW(whatThereIs.Require(*available * 2), InvalidInput);
}

TEST_F(FilterMemory, DoesNotGrowOverAThousandExecutions)
{
  AllocateInOnePlace();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  this->Filter->SetInputConnection(sphere->GetOutputPort());
  this->Filter->SetPhotons(2048);
  const auto execute = [&](int times)
  {
    for (int i = 0; i < times; ++i)
    {
      this->Filter->SetSeed(this->Filter->GetSeed() + 1);
      this->Filter->SetRegisterBackSide(i % 2 == 0);
      this->Filter->SetLampType(i % 3);
      this->Filter->SetReflectance(i % 50 == 49 ? 2.0 : 0.5); // errors give back too
      this->Filter->Update();
    }
  };
  if (!MeasuresMemory)
  {
    execute(20); // the sanitizer itself looks for leaks when the process ends
    return;
  }
  // Of what is allocated: pages stay with the process as long as one small piece on them is in use.
  execute(100); // caches fill
  const double before = Allocated();
  ASSERT_GT(before, 0.0) << "the library tells";
  execute(1000);
  const double growth = Allocated() - before;
  // The least that a run could leave behind each time and still be worth the name of a leak is one
  // array of one number a point.
  const double leastLeak =
    1000.0 * 8.0 * static_cast<double>(sphere->GetOutput()->GetNumberOfPoints());
  this->Measured("1000 runs leave less than half an array of one number a point each");
  EXPECT_LT(growth, 0.5 * leastLeak);
}
