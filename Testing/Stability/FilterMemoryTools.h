// SPDX-License-Identifier: BSD-3-Clause
// What the filter takes beside what it said.
#pragma once

#include "FilterTools.h"
#include "ProcessMemory.h"

#include "vtkSphereSource.h"

#include <cmath>
#include <string>

#if defined(__SANITIZE_ADDRESS__)
/// It keeps freed memory for a while, and looks for leaks by itself.
inline constexpr bool MeasuresMemory = false;
#else
inline constexpr bool MeasuresMemory = true;
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
    if (ProcessMemory::Status("VmRSS:") == 0.0)
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
    ProcessMemory::GiveBack();
    const double before = ProcessMemory::Status("VmRSS:");
    ProcessMemory::ForgetPeak();
    this->Filter->SetInputData(surface);
    this->ExpectMap();
    const double taken = ProcessMemory::Status("VmHWM:") - before;
    // Without the numbers, which differ from run to run: the table shall not.
    this->Measured("between " + std::to_string(std::lround(100.0 * least)) +
      " % and all of what it said was taken");
    // VTK's own cutting and copying comes before, and is no more than this run.
    EXPECT_LT(taken, this->Needed());
    EXPECT_GT(taken, least * this->Needed()) << "it would refuse what could be run";
  }
};

/// 1000 x 500 points and nearly a million triangles, or fewer.
inline vtkSmartPointer<vtkPolyData> LargeSphere(int around = 1000, int along = 500)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(around);
  sphere->SetPhiResolution(along);
  sphere->Update();
  return sphere->GetOutput();
}

/// With few rays for each vertex.
inline void Gather(vtkIlluminationMap* filter)
{
  filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  filter->SetGatherRays(16);
}
