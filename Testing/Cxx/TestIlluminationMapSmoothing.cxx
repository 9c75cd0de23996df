// SPDX-License-Identifier: BSD-3-Clause
// The smoothing filter: arrays, what it goes by, blocks, errors, abort.
#include "TestTools.h"

#include "vtkIlluminationMapSmoothing.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"

#include <cmath>

namespace
{

vtkSmartPointer<vtkPolyData> LitSphere(bool groupMeans)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(sphere->GetOutputPort());
  illuminate->SetPhotons(50000);
  illuminate->SetGroupMeans(groupMeans);
  illuminate->Update();
  return illuminate->GetOutput();
}

void CheckArrays(vtkPolyData* input, vtkPolyData* output, bool parts, Checks& check)
{
  vtkPointData* arrays = output->GetPointData();
  for (const char* name : { "IlluminanceSmoothed", "StandardErrorSmoothed", "SmoothingScale" })
  {
    check(arrays->HasArray(name) != 0, std::string(name) + " is there");
  }
  check(PointArray(output, "Illuminance") == PointArray(input, "Illuminance"),
    "the input's arrays are untouched");
  check(!input->GetPointData()->HasArray("IlluminanceSmoothed"), "and the input has no new ones");
  const char* direct = "IlluminanceDirectSmoothed";
  check((arrays->HasArray(direct) != 0) == parts, "parts are there if they were smoothed");
  const int components = PointArray(output, "SmoothingScale")->GetNumberOfComponents();
  check(components == (parts ? 2 : 1), "a scale for each part");
  if (parts)
  {
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const double sum = PointArray(output, direct)->GetTuple1(p) +
        PointArray(output, "IlluminanceIndirectSmoothed")->GetTuple1(p);
      check(sum == PointArray(output, "IlluminanceSmoothed")->GetTuple1(p), "parts add up");
    }
  }
}

/// The error that an execution gives; empty if it gives none.
std::string ErrorOf(vtkIlluminationMapSmoothing* smooth)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = smooth->AddObserver(vtkCommand::ErrorEvent, observer);
  smooth->Update();
  smooth->RemoveObserver(tag);
  return observer->GetErrorMessage();
}

void CheckErrors(Checks& check)
{
  const auto map = LitSphere(false);
  vtkNew<vtkIlluminationMapSmoothing> smooth;
  smooth->SetInputData(map);
  const auto expect = [&](const std::string& message)
  {
    const std::string error = ErrorOf(smooth);
    check(
      error.find(message) != std::string::npos, "expected '" + message + "', not '" + error + "'");
    check(smooth->GetOutput()->GetNumberOfPoints() == map->GetNumberOfPoints() &&
        !PointArray(smooth->GetOutput(), "IlluminanceSmoothed"),
      "the input passes through");
  };
  smooth->SetIlluminanceArray("Lux");
  expect("there is no point array 'Lux'");
  smooth->SetIlluminanceArray("Normals");
  expect("point array 'Normals' has 3 components; 1 is wanted");
  smooth->SetIlluminanceArray("Illuminance");
  smooth->SetFeatureAngle(std::nan(""));
  expect("FeatureAngle is nan; it must be within [0, 180] degrees");
  smooth->SetFeatureAngle(40.0);
  smooth->SetStrength(11.0);
  expect("the strength is 11.000000; it must be within [0, 10]");
  smooth->SetStrength(1.0);
  smooth->SetNumberOfThreads(-1);
  expect("the number of threads is -1");
  smooth->SetNumberOfThreads(0);
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(map);
  PointArray(broken, "Illuminance")->SetTuple1(7, std::nan(""));
  smooth->SetInputData(broken);
  expect("point 7: Illuminance is nan; it must be a finite number >= 0");
  smooth->SetInputData(map);
  check(ErrorOf(smooth).empty() && PointArray(smooth->GetOutput(), "IlluminanceSmoothed"),
    "after errors the filter works");
}

void CheckBlocks(vtkPolyData* map, vtkIlluminationMapSmoothing* alone, Checks& check)
{
  vtkNew<vtkPlaneSource> dark;
  dark->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, map);
  blocks->SetBlock(2, map);
  vtkNew<vtkIlluminationMapSmoothing> smooth;
  smooth->SetInputData(blocks);
  smooth->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(smooth->GetOutputDataObject(0));
  auto* block = output ? vtkPolyData::SafeDownCast(output->GetBlock(2)) : nullptr;
  check(block && PointArray(block, "IlluminanceSmoothed"), "a block comes back with its arrays");
  double differences = 0.0;
  double errors = 0.0;
  for (vtkIdType p = 0; block && p < block->GetNumberOfPoints(); ++p)
  {
    const double difference = PointArray(block, "IlluminanceSmoothed")->GetTuple1(p) -
      PointArray(alone->GetOutput(), "IlluminanceSmoothed")->GetTuple1(p);
    differences += difference * difference;
    const double error = PointArray(alone->GetOutput(), "StandardErrorSmoothed")->GetTuple1(p);
    errors += error * error;
  }
  // Widths are chosen by what is known of the whole scene, so the bits may differ.
  check(differences <= errors, "a block is smoothed as it is alone");
  blocks->SetBlock(1, dark->GetOutput());
  smooth->Modified();
  check(
    ErrorOf(smooth).find("there is no point array 'Illuminance' of block 2") != std::string::npos,
    "a block without a map is named");
}

void CheckAbort(vtkPolyData* map, Checks& check)
{
  vtkNew<vtkIlluminationMapSmoothing> smooth;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  smooth->SetInputData(map);
  const unsigned long tag = smooth->AddObserver(vtkCommand::ProgressEvent, stop);
  smooth->Update();
  check(smooth->GetOutput()->GetNumberOfPoints() == map->GetNumberOfPoints() &&
      !PointArray(smooth->GetOutput(), "IlluminanceSmoothed"),
    "an abort lets the input pass through");
  smooth->RemoveObserver(tag);
  smooth->SetAbortExecute(0);
  smooth->Modified();
  smooth->Update();
  check(PointArray(smooth->GetOutput(), "IlluminanceSmoothed") != nullptr, "and it runs again");
}

} // namespace

int TestIlluminationMapSmoothing(int, char*[])
{
  Checks check;
  for (const bool groupMeans : { false, true })
  {
    const auto map = LitSphere(groupMeans);
    vtkNew<vtkIlluminationMapSmoothing> smooth;
    smooth->SetInputData(map);
    smooth->Update();
    CheckArrays(map, smooth->GetOutput(), groupMeans, check);
    const std::string note = FieldText(smooth->GetOutput(), "SmoothingNotes");
    check(note.find(groupMeans ? "four groups" : "'StandardError'") != std::string::npos,
      "the note says what it went by, not: " + note);
    CheckBlocks(map, smooth, check);
    CheckAbort(map, check);

    smooth->SetStandardErrorArray("None");
    smooth->SetMethod(vtkIlluminationMapSmoothing::NONE);
    smooth->Update();
    if (!groupMeans)
    {
      check(SameValues(PointArray(smooth->GetOutput(), "IlluminanceSmoothed"),
              PointArray(map, "Illuminance")),
        "no method, no change");
      check(FieldText(smooth->GetOutput(), "SmoothingNotes").find("roughness") != std::string::npos,
        "roughness is the last resort");
    }
  }
  CheckErrors(check);
  return check.Failures();
}
