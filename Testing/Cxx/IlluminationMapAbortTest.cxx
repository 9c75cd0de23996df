// SPDX-License-Identifier: BSD-3-Clause
// Abort ends the run soon and leaves a valid map of the photons that were traced.
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

struct Watch
{
  int progressEvents = 0;
  double last = 0.0;
  bool falls = false;
};

void AbortAfterSomeProgress(vtkObject* caller, unsigned long, void* clientData, void*)
{
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  auto* watch = static_cast<Watch*>(clientData);
  ++watch->progressEvents;
  watch->falls = watch->falls || filter->GetProgress() < watch->last;
  watch->last = filter->GetProgress();
  if (watch->progressEvents == 4)
  {
    filter->SetAbortExecute(1);
  }
}

} // namespace

TEST(IlluminationMap, AbortLeavesAMapOfThePhotonsTraced)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(sphere->GetOutputPort());
  illuminate->SetPhotons(4000000000LL); // many minutes
  illuminate->SetReflectance(0.0);
  Watch watch;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(AbortAfterSomeProgress);
  observer->SetClientData(&watch);
  const auto tag = illuminate->AddObserver(vtkCommand::ProgressEvent, observer);
  illuminate->Update();

  vtkPolyData* output = illuminate->GetOutput();
  EXPECT_TRUE(watch.progressEvents >= 4 && !watch.falls) << "progress rises";
  EXPECT_EQ(FieldText(output, "StoppedBy"), "abort\n") << "the output says what ended it";
  const double emitted = FieldValue(output, "PhotonsEmitted");
  EXPECT_TRUE(emitted > 0.0 && emitted < 4e8) << "a part was traced: " << emitted;
  EXPECT_EQ(emitted, FieldValue(output, "PhotonsAbsorbed") + FieldValue(output, "PhotonsEscaped"))
    << "the partial run is balanced";
  vtkDataArray* map = PointArray(output, "Illuminance");
  // The pole faces the light: 1000 lx.
  EXPECT_TRUE(map &&
    std::fabs(map->GetTuple1(0) - 1000.0) <
      5.0 * PointArray(output, "StandardError")->GetTuple1(0) + 1.0)
    << "the partial map is right";

  illuminate->RemoveObserver(tag);
  illuminate->SetAbortExecute(0);
  illuminate->SetPhotons(10000);
  illuminate->Update();
  EXPECT_EQ(FieldText(illuminate->GetOutput(), "StoppedBy"), "photon limit\n")
    << "and it runs again";
}
