// SPDX-License-Identifier: BSD-3-Clause
// The smoothing filter: arrays, what it goes by, blocks, errors, abort.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkIlluminationMapSmoothing.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

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

void CheckArrays(vtkPolyData* input, vtkPolyData* output, bool parts)
{
  vtkPointData* arrays = output->GetPointData();
  for (const char* name : { "IlluminanceSmoothed", "StandardErrorSmoothed", "SmoothingScale" })
  {
    EXPECT_NE(arrays->HasArray(name), 0) << name << " is there";
  }
  EXPECT_EQ(PointArray(output, "Illuminance"), PointArray(input, "Illuminance"))
    << "the input's arrays are untouched";
  EXPECT_FALSE(input->GetPointData()->HasArray("IlluminanceSmoothed"))
    << "and the input has no new ones";
  const char* direct = "IlluminanceDirectSmoothed";
  EXPECT_EQ(arrays->HasArray(direct) != 0, parts) << "parts are there if they were smoothed";
  const int components = PointArray(output, "SmoothingScale")->GetNumberOfComponents();
  EXPECT_EQ(components, parts ? 2 : 1) << "a scale for each part";
  if (parts)
  {
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const double sum = PointArray(output, direct)->GetTuple1(p) +
        PointArray(output, "IlluminanceIndirectSmoothed")->GetTuple1(p);
      EXPECT_EQ(sum, PointArray(output, "IlluminanceSmoothed")->GetTuple1(p)) << "parts add up";
    }
  }
}

void CheckBlocks(vtkPolyData* map, vtkIlluminationMapSmoothing* alone)
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
  EXPECT_TRUE(block && PointArray(block, "IlluminanceSmoothed"))
    << "a block comes back with its arrays";
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
  EXPECT_LE(differences, errors) << "a block is smoothed as it is alone";
  blocks->SetBlock(1, dark->GetOutput());
  smooth->Modified();
  EXPECT_TRUE(Holds(ErrorOf(smooth), "there is no point array 'Illuminance' of block 2"))
    << "a block without a map is named";
}

void CheckAbort(vtkPolyData* map)
{
  vtkNew<vtkIlluminationMapSmoothing> smooth;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  smooth->SetInputData(map);
  const unsigned long tag = smooth->AddObserver(vtkCommand::ProgressEvent, stop);
  smooth->Update();
  EXPECT_TRUE(smooth->GetOutput()->GetNumberOfPoints() == map->GetNumberOfPoints() &&
    !PointArray(smooth->GetOutput(), "IlluminanceSmoothed"))
    << "an abort lets the input pass through";
  smooth->RemoveObserver(tag);
  smooth->SetAbortExecute(0);
  smooth->Modified();
  smooth->Update();
  EXPECT_NE(PointArray(smooth->GetOutput(), "IlluminanceSmoothed"), nullptr) << "and it runs again";
}

} // namespace

TEST(IlluminationMapSmoothing, AddsArraysByGroupsOrByTheError)
{
  for (const bool groupMeans : { false, true })
  {
    const auto map = LitSphere(groupMeans);
    vtkNew<vtkIlluminationMapSmoothing> smooth;
    smooth->SetInputData(map);
    smooth->Update();
    CheckArrays(map, smooth->GetOutput(), groupMeans);
    const std::string note = FieldText(smooth->GetOutput(), "SmoothingNotes");
    EXPECT_TRUE(Holds(note, groupMeans ? "four groups" : "'StandardError'"))
      << "the note says what it went by, not: " << note;
    CheckBlocks(map, smooth);
    CheckAbort(map);

    smooth->SetStandardErrorArray("None");
    smooth->SetMethod(vtkIlluminationMapSmoothing::NONE);
    smooth->Update();
    if (!groupMeans)
    {
      EXPECT_TRUE(SameValues(
        PointArray(smooth->GetOutput(), "IlluminanceSmoothed"), PointArray(map, "Illuminance")))
        << "no method, no change";
      EXPECT_TRUE(Holds(FieldText(smooth->GetOutput(), "SmoothingNotes"), "roughness"))
        << "roughness is the last resort";
    }
  }
}

TEST(IlluminationMapSmoothing, ErrorsLetTheInputPassThrough)
{
  const auto map = LitSphere(false);
  vtkNew<vtkIlluminationMapSmoothing> smooth;
  smooth->SetInputData(map);
  const auto expect = [&](const std::string& message)
  {
    EXPECT_TRUE(Holds(ErrorOf(smooth), message));
    EXPECT_TRUE(smooth->GetOutput()->GetNumberOfPoints() == map->GetNumberOfPoints() &&
      !PointArray(smooth->GetOutput(), "IlluminanceSmoothed"))
      << "the input passes through";
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
  EXPECT_TRUE(ErrorOf(smooth).empty() && PointArray(smooth->GetOutput(), "IlluminanceSmoothed"))
    << "after errors the filter works";
}
