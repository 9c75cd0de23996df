// SPDX-License-Identifier: BSD-3-Clause
// What a run takes: told before, not exceeded, refused where it is too much, and given back.
#include "FilterMemoryTools.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/MemoryLimit.h"

#include "vtkLuminaireSource.h"

#include "vtkReverseSense.h"

#include <limits>

using namespace ProcessMemory;

namespace
{

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

} // namespace

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
