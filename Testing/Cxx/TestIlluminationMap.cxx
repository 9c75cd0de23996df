// SPDX-License-Identifier: BSD-3-Clause
// What the output holds: the input untouched, arrays that add up, a balanced account of photons.
#include "TestTools.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{

void CheckArrays(vtkPolyData* output, Checks& check)
{
  for (const char* name : { "Illuminance", "IlluminanceDirect", "IlluminanceIndirect",
         "StandardError", "RelativeError", "PhotonHits", "IlluminanceBack", "StandardErrorBack" })
  {
    vtkDataArray* array = PointArray(output, name);
    check(array && array->GetNumberOfTuples() == output->GetNumberOfPoints(), name);
  }
  if (check.Failures() > 0)
  {
    return;
  }
  double brightest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double total = PointArray(output, "Illuminance")->GetTuple1(i);
    const double sum = PointArray(output, "IlluminanceDirect")->GetTuple1(i) +
      PointArray(output, "IlluminanceIndirect")->GetTuple1(i);
    check(total == sum, "direct + indirect = total at point " + std::to_string(i));
    check(std::isfinite(total) && total >= 0.0, "illuminance is finite and >= 0");
    brightest = std::max(brightest, total);
  }
  // The brightest vertex of the sphere faces the light within half a facet, 15 degrees.
  check(brightest > 965.0 && brightest < 1010.0, "brightest point: " + std::to_string(brightest));
  check(std::string(output->GetPointData()->GetScalars()->GetName()) == "Illuminance",
    "the new map is the active scalar");
}

void CheckFieldData(vtkPolyData* output, Checks& check)
{
  const double emitted = FieldValue(output, "PhotonsEmitted");
  check(emitted >= 100000.0, "emitted");
  check(emitted ==
      FieldValue(output, "PhotonsAbsorbed") + FieldValue(output, "PhotonsEscaped") +
        FieldValue(output, "PhotonsCutOff"),
    "photon balance");
  // Light of 1000 lx from above through the bounding disk of a sphere of 0.5 units of 2 m. Its
  // widest ring of points is at 9 * 180 / 22 degrees from the pole: pi sin^2 square metres.
  check(std::fabs(FieldValue(output, "EmittedFlux") / 3077.96 - 1.0) < 1e-5, "emitted flux");
  check(FieldValue(output, "Seconds") > 0.0, "seconds");
  check(FieldValue(output, "PhotonsPerSecond") > 0.0, "photons per second");
  check(FieldValue(output, "SegmentsPerSecond") > 0.0, "segments per second");
  check(FieldValue(output, "FluxCutByWeightBound") >= 0.0, "flux cut by the bound");
  check(FieldText(output, "StoppedBy") == "photon limit\n", "stopped by");
  check(FieldText(output, "Effects").find("interreflection: on") != std::string::npos, "effects");
  check(!FieldText(output, "IlluminationMapsVersion").empty(), "version");
}

} // namespace

int TestIlluminationMap(int, char*[])
{
  Checks check;
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
  check(output->GetPoints() == sphere->GetOutput()->GetPoints(), "points pass untouched");
  check(output->GetPolys() == sphere->GetOutput()->GetPolys(), "cells pass untouched");
  check(!PointArray(sphere->GetOutput(), "Illuminance"), "the input gets no array");
  CheckArrays(output, check);
  CheckFieldData(output, check);

  vtkNew<vtkPolyData> alone;
  alone->ShallowCopy(output);
  illuminate->SetNumberOfThreads(7);
  illuminate->Update();
  for (const char* name : { "Illuminance", "IlluminanceBack", "StandardError", "PhotonHits" })
  {
    check(SameValues(PointArray(alone, name), PointArray(illuminate->GetOutput(), name)),
      std::string(name) + " has the same bits for 1 and 7 threads");
  }
  illuminate->SetSeed(2);
  illuminate->Update();
  check(!SameValues(
          PointArray(alone, "Illuminance"), PointArray(illuminate->GetOutput(), "Illuminance")),
    "another seed gives another map");
  return check.Failures();
}
