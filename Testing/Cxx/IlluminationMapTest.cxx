// SPDX-License-Identifier: BSD-3-Clause
// What the output holds: the input untouched, arrays that add up, a balanced account of photons.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{

void CheckArrays(vtkPolyData* output)
{
  for (const char* name : { "Illuminance", "IlluminanceDirect", "IlluminanceIndirect",
         "StandardError", "RelativeError", "PhotonHits", "IlluminanceBack", "StandardErrorBack" })
  {
    vtkDataArray* array = PointArray(output, name);
    EXPECT_TRUE(array && array->GetNumberOfTuples() == output->GetNumberOfPoints()) << name;
  }
  if (::testing::Test::HasFailure())
  {
    return;
  }
  double brightest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double total = PointArray(output, "Illuminance")->GetTuple1(i);
    const double sum = PointArray(output, "IlluminanceDirect")->GetTuple1(i) +
      PointArray(output, "IlluminanceIndirect")->GetTuple1(i);
    EXPECT_EQ(total, sum) << "direct + indirect = total at point " << i;
    EXPECT_TRUE(std::isfinite(total) && total >= 0.0) << "illuminance is finite and >= 0";
    brightest = std::max(brightest, total);
  }
  // The brightest vertex of the sphere faces the light within half a facet, 15 degrees.
  EXPECT_TRUE(brightest > 965.0 && brightest < 1010.0) << "brightest point: " << brightest;
  EXPECT_EQ(std::string(output->GetPointData()->GetScalars()->GetName()), "Illuminance")
    << "the new map is the active scalar";
}

void CheckFieldData(vtkPolyData* output)
{
  const double emitted = FieldValue(output, "PhotonsEmitted");
  EXPECT_GE(emitted, 100000.0) << "emitted";
  EXPECT_EQ(emitted,
    FieldValue(output, "PhotonsAbsorbed") + FieldValue(output, "PhotonsEscaped") +
      FieldValue(output, "PhotonsCutOff"))
    << "photon balance";
  // Light of 1000 lx from above through the bounding disk of a sphere of 0.5 units of 2 m. Its
  // widest ring of points is at 9 * 180 / 22 degrees from the pole: pi sin^2 square metres.
  EXPECT_LT(std::fabs(FieldValue(output, "EmittedFlux") / 3077.96 - 1.0), 1e-5) << "emitted flux";
  EXPECT_GT(FieldValue(output, "Seconds"), 0.0) << "seconds";
  EXPECT_GT(FieldValue(output, "PhotonsPerSecond"), 0.0) << "photons per second";
  EXPECT_GT(FieldValue(output, "SegmentsPerSecond"), 0.0) << "segments per second";
  EXPECT_GE(FieldValue(output, "FluxCutByWeightBound"), 0.0) << "flux cut by the bound";
  EXPECT_EQ(FieldText(output, "StoppedBy"), "photon limit\n") << "stopped by";
  EXPECT_TRUE(Holds(FieldText(output, "Effects"), "interreflection: on")) << "effects";
  EXPECT_FALSE(FieldText(output, "IlluminationMapsVersion").empty()) << "version";
}

} // namespace

TEST(IlluminationMap, AddsArraysAndAnAccountOfPhotons)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(12);
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(sphere->GetOutputPort());
  illuminate->SetPhotons(100000);
  illuminate->SetMetresPerUnit(2.0);
  illuminate->RegisterBackSideOn();
  illuminate->SetNumberOfThreads(1);
  illuminate->Update();

  vtkPolyData* output = illuminate->GetOutput();
  EXPECT_EQ(output->GetPoints(), sphere->GetOutput()->GetPoints()) << "points pass untouched";
  EXPECT_EQ(output->GetPolys(), sphere->GetOutput()->GetPolys()) << "cells pass untouched";
  EXPECT_FALSE(PointArray(sphere->GetOutput(), "Illuminance")) << "the input gets no array";
  CheckArrays(output);
  CheckFieldData(output);

  vtkNew<vtkPolyData> alone;
  alone->ShallowCopy(output);
  illuminate->SetNumberOfThreads(7);
  illuminate->Update();
  for (const char* name : { "Illuminance", "IlluminanceBack", "StandardError", "PhotonHits" })
  {
    EXPECT_TRUE(SameValues(PointArray(alone, name), PointArray(illuminate->GetOutput(), name)))
      << name << " has the same bits for 1 and 7 threads";
  }
  illuminate->SetSeed(2);
  illuminate->Update();
  EXPECT_FALSE(SameValues(
    PointArray(alone, "Illuminance"), PointArray(illuminate->GetOutput(), "Illuminance")))
    << "another seed gives another map";
}
