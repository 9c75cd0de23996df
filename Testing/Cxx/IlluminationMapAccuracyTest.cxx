// SPDX-License-Identifier: BSD-3-Clause
// The filter goes on where it can, starts anew where it must, stops at an accuracy, and shows in
// the table Accuracy what it cost.
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

double Cell(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

vtkIdType Emitted(vtkIlluminationMap* illuminate)
{
  return static_cast<vtkIdType>(FieldValue(illuminate->GetOutput(), "PhotonsEmitted"));
}

/// Traced in one go by another filter with the same properties.
void CheckAgainstOneGo(vtkIlluminationMap* illuminate, vtkSphereSource* sphere)
{
  vtkNew<vtkIlluminationMap> once;
  once->SetInputConnection(sphere->GetOutputPort());
  once->SetPhotons(illuminate->GetPhotons());
  once->SetSeed(illuminate->GetSeed());
  once->Update();
  for (const char* name : { "Illuminance", "StandardError", "PhotonHits" })
  {
    EXPECT_TRUE(
      SameValues(PointArray(illuminate->GetOutput(), name), PointArray(once->GetOutput(), name)))
      << name << " has the bits of a run in one go";
  }
}

void CheckTable(vtkIlluminationMap* illuminate)
{
  auto* table = vtkTable::SafeDownCast(illuminate->GetOutputDataObject(1));
  EXPECT_TRUE(table && table->GetNumberOfRows() >= 3) << "a row for each round";
  if (!table || table->GetNumberOfRows() < 3)
  {
    return;
  }
  const vtkIdType last = table->GetNumberOfRows() - 1;
  EXPECT_EQ(Cell(table, last, "Photons"), static_cast<double>(Emitted(illuminate))) << "photons";
  for (vtkIdType row = 1; row <= last; ++row)
  {
    EXPECT_GT(Cell(table, row, "Photons"), Cell(table, row - 1, "Photons")) << "photons grow";
    EXPECT_GT(Cell(table, row, "Seconds"), Cell(table, row - 1, "Seconds")) << "seconds grow";
    EXPECT_GT(Cell(table, row, "SegmentsPerSecond"), 0.0) << "a rate";
    EXPECT_LE(
      Cell(table, row, "MedianRelativeError"), Cell(table, row, "Percentile95RelativeError"))
      << "median and 95th percentile";
  }
}

} // namespace

TEST(IlluminationMap, GoesOnStartsAnewAndStopsAtAnAccuracy)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(sphere->GetOutputPort());
  illuminate->SetPhotons(50000);
  illuminate->Update();
  const double before = FieldValue(illuminate->GetOutput(), "Seconds");

  illuminate->SetPhotons(200000);
  illuminate->Update();
  EXPECT_GT(FieldValue(illuminate->GetOutput(), "Seconds"), before) << "it went on: time adds up";
  CheckTable(illuminate);
  CheckAgainstOneGo(illuminate, sphere);

  illuminate->SetPhotons(30000); // fewer: anew
  illuminate->Update();
  EXPECT_EQ(Emitted(illuminate), 30720) << "30000 rounded up to whole blocks";
  CheckAgainstOneGo(illuminate, sphere);
  illuminate->SetSeed(5); // another map: anew
  illuminate->Update();
  CheckAgainstOneGo(illuminate, sphere);
  sphere->SetRadius(3.0); // another surface: anew
  illuminate->Update();
  CheckAgainstOneGo(illuminate, sphere);

  illuminate->SetPhotons(2000000000);
  illuminate->SetTargetRelativeError(0.0003);
  illuminate->Update();
  EXPECT_EQ(FieldText(illuminate->GetOutput(), "StoppedBy"), "target relative error\n") << "target";
  auto* table = vtkTable::SafeDownCast(illuminate->GetOutputDataObject(1));
  EXPECT_LE(Cell(table, table->GetNumberOfRows() - 1, "RelativeError"), 0.0003) << "target reached";
  EXPECT_GT(FieldValue(illuminate->GetOutput(), "PredictedSeconds"), 0.0) << "a prediction";

  illuminate->SetTargetRelativeError(0.0);
  illuminate->SetTimeLimit(FieldValue(illuminate->GetOutput(), "Seconds") + 0.05);
  illuminate->Update();
  EXPECT_EQ(FieldText(illuminate->GetOutput(), "StoppedBy"), "time limit\n") << "time limit";
}

TEST(IlluminationMap, TellsTheErrorOfFacetSizeAndCountsItIfAsked)
{
  vtkNew<vtkPlaneSource> floor; // under the lamp, of facets that are large for its distance
  floor->SetResolution(6, 6);
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(floor->GetOutputPort());
  illuminate->SetLampType(vtkIlluminationMap::POINT);
  illuminate->SetLampPosition(0.05, 0.1, 0.3);
  illuminate->SetPhotons(2000000000);
  illuminate->SetTargetRelativeError(0.02);
  illuminate->Update();
  EXPECT_EQ(FieldText(illuminate->GetOutput(), "StoppedBy"), "target relative error\n");
  auto* table = vtkTable::SafeDownCast(illuminate->GetOutputDataObject(1));
  EXPECT_EQ(Cell(table, table->GetNumberOfRows() - 1, "RelativeFacetError"), 0.0) << "not counted";

  illuminate->CountFacetErrorOn();
  illuminate->Update();
  const std::string reason = FieldText(illuminate->GetOutput(), "StoppedBy");
  EXPECT_EQ(reason.rfind("facets too large for the target", 0), 0u) << reason;
  EXPECT_NE(reason.find("Final Gathering"), std::string::npos) << reason;
  EXPECT_GT(Cell(table, table->GetNumberOfRows() - 1, "RelativeFacetError"), 0.02) << "counted";
  vtkDataArray* error = PointArray(illuminate->GetOutput(), "FacetError");
  ASSERT_TRUE(error && error->GetNumberOfTuples() == illuminate->GetOutput()->GetNumberOfPoints());
  EXPECT_GT(error->GetRange()[1], 0.0);
  EXPECT_GE(error->GetRange()[0], 0.0);

  illuminate->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  illuminate->SetPhotons(10000);
  illuminate->SetGatherRays(16);
  illuminate->Update();
  EXPECT_FALSE(PointArray(illuminate->GetOutput(), "FacetError"));
}
