// SPDX-License-Identifier: BSD-3-Clause
// The map on a surface that is refined where its light varies: blocks, arrays, limits.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <map>
#include <tuple>

namespace
{

/// A square in x, y of one quadrilateral.
vtkSmartPointer<vtkPolyData> Square(double x0, double y0, double side, double z)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(x0, y0, z);
  source->SetPoint1(x0 + side, y0, z);
  source->SetPoint2(x0, y0 + side, z);
  source->Update();
  return source->GetOutput();
}

/// A floor in two blocks beside each other, and a square that shadows it.
vtkSmartPointer<vtkMultiBlockDataSet> Scene()
{
  const auto left = Square(-2.0, -1.0, 2.0, 0.0);
  vtkNew<vtkDoubleArray> height;
  height->SetName("X");
  vtkNew<vtkStringArray> corner;
  corner->SetName("Corner");
  for (vtkIdType p = 0; p < left->GetNumberOfPoints(); ++p)
  {
    height->InsertNextValue(left->GetPoint(p)[0]);
    corner->InsertNextValue("corner " + std::to_string(p));
  }
  left->GetPointData()->AddArray(height);
  left->GetPointData()->AddArray(corner);
  vtkNew<vtkDoubleArray> part;
  part->SetName("Part");
  part->InsertNextValue(7.0);
  left->GetCellData()->AddArray(part);
  auto scene = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  scene->SetBlock(0, left);
  scene->SetBlock(1, Square(0.0, -1.0, 2.0, 0.0));
  scene->SetBlock(2, Square(-0.2, -0.3, 0.5, 1.0));
  return scene;
}

vtkSmartPointer<vtkIlluminationMap> Filter(vtkDataObject* data)
{
  auto filter = vtkSmartPointer<vtkIlluminationMap>::New();
  filter->SetInputDataObject(data);
  filter->SetLampType(vtkIlluminationMap::POINT);
  filter->SetLampPosition(0.1, 0.0, 2.0);
  filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  filter->SetPhotons(20000);
  filter->SetGatherRays(16);
  filter->SetReflectance(0.2);
  filter->SetRefinementTolerance(0.2);
  return filter;
}

vtkPolyData* Block(vtkIlluminationMap* filter, unsigned block)
{
  return vtkPolyData::SafeDownCast(
    vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetBlock(block));
}

} // namespace

TEST(AdaptiveRefinement, RefinesBlocksAlikeAndCarriesArraysOver)
{
  const auto filter = Filter(Scene());
  ASSERT_EQ(ErrorOf(filter), "");
  const auto plain = vtkSmartPointer<vtkPolyData>::New();
  plain->DeepCopy(Block(filter, 0));
  EXPECT_EQ(plain->GetNumberOfCells(), 1) << "it is off by default";
  const double seconds = FieldValue(filter->GetOutputDataObject(0), "Seconds");
  filter->SetAdaptiveRefinement(true);
  ASSERT_EQ(ErrorOf(filter), "");
  EXPECT_EQ(FieldValue(filter->GetOutputDataObject(0), "Seconds"), seconds) << "the run is kept";
  vtkPolyData* left = Block(filter, 0);
  EXPECT_GT(left->GetNumberOfCells(), 300);
  for (const char* name : { "Illuminance", "IlluminanceDirect", "IlluminanceIndirect",
         "IlluminanceCaustic", "StandardError", "RelativeError" })
  {
    vtkDataArray* array = PointArray(left, name);
    ASSERT_TRUE(array) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), left->GetNumberOfPoints());
    for (vtkIdType p = 0; p < 4; ++p)
    {
      EXPECT_EQ(array->GetTuple1(p), PointArray(plain, name)->GetTuple1(p)) << name;
    }
  }
  for (vtkIdType p = 0; p < left->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(PointArray(left, "X")->GetTuple1(p), left->GetPoint(p)[0], 1e-6);
    EXPECT_EQ(PointArray(left, "OriginalPointIds")->GetTuple1(p), p < 4 ? p : -1);
  }
  EXPECT_TRUE(left->GetPointData()->GetAbstractArray("Corner"));
  for (vtkIdType c = 0; c < left->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(left->GetCellData()->GetArray("Part")->GetTuple1(c), 7.0);
    EXPECT_EQ(left->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(c), 0.0);
  }
  // Both blocks have the same points where they meet, with the same light but for noise.
  std::map<double, double> onBorder[2];
  for (const unsigned b : { 0u, 1u })
  {
    vtkPolyData* block = Block(filter, b);
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      if (block->GetPoint(p)[0] == 0.0)
      {
        onBorder[b][block->GetPoint(p)[1]] = PointArray(block, "IlluminanceDirect")->GetTuple1(p);
      }
    }
  }
  EXPECT_GT(onBorder[0].size(), 10u);
  ASSERT_EQ(onBorder[0].size(), onBorder[1].size());
  for (const auto& [y, lux] : onBorder[0])
  {
    ASSERT_TRUE(onBorder[1].count(y)) << y;
    const double far = y * y + 0.01 + 4.0;
    const bool shadow = y > -0.6 && y < 0.4;
    const double exact =
      shadow ? 0.0 : 1000.0 / (4.0 * 3.14159265358979) * 2.0 / std::pow(far, 1.5);
    EXPECT_NEAR(lux, exact, 0.01 * exact) << y;
  }
}

TEST(AdaptiveRefinement, IsForFinalGatheringOnly)
{
  const auto filter = Filter(Scene());
  filter->SetAdaptiveRefinement(true);
  filter->SetMethod(vtkIlluminationMap::PHOTON_TRACING);
  EXPECT_EQ(ErrorOf(filter), "");
  EXPECT_EQ(Block(filter, 0)->GetNumberOfCells(), 1);
}

TEST(AdaptiveRefinement, SaysSoWhenCellsAreTooFew)
{
  const auto filter = Filter(Scene());
  filter->SetAdaptiveRefinement(true);
  filter->SetMaximumCells(200);
  const CaughtMessages messages;
  filter->Update();
  EXPECT_TRUE(Holds(messages->Text, "MaximumCells"));
  EXPECT_TRUE(Holds(FieldText(filter->GetOutputDataObject(0), "Notes"), "MaximumCells"));
  vtkIdType cells = 0;
  for (const unsigned b : { 0u, 1u, 2u })
  {
    cells += Block(filter, b)->GetNumberOfCells();
  }
  EXPECT_LE(cells, 200);
  EXPECT_GT(cells, 150);
}

// A point where normals are split has the mean of its sides; refined, each side has its own.
TEST(AdaptiveRefinement, SharpEdgesGetAPointForEachSide)
{
  vtkNew<vtkPoints> points;
  for (const auto& [x, y, z] :
    { std::tuple(0.0, 0.0, 0.0), std::tuple(1.0, 0.0, 0.0), std::tuple(1.0, 1.0, 0.0),
      std::tuple(0.0, 1.0, 0.0), std::tuple(0.0, 0.0, 1.0), std::tuple(0.0, 1.0, 1.0) })
  {
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  cells->InsertNextCell({ 0, 3, 5, 4 });
  vtkNew<vtkPolyData> corner;
  corner->SetPoints(points);
  corner->SetPolys(cells);
  const auto filter = Filter(corner);
  filter->SetLampPosition(0.8, 0.5, 0.7);
  filter->SetAdaptiveRefinement(true);
  ASSERT_EQ(ErrorOf(filter), "");
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  std::map<std::tuple<double, double, double>, int> places;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double* at = output->GetPoint(p);
    ++places[{ at[0], at[1], at[2] }];
    EXPECT_GT(PointArray(output, "Illuminance")->GetTuple1(p), 0.0);
  }
  int onEdge = 0;
  for (const auto& [place, number] : places)
  {
    const bool isOnEdge = std::get<0>(place) == 0.0 && std::get<2>(place) == 0.0;
    EXPECT_EQ(number, isOnEdge ? 2 : 1);
    onEdge += isOnEdge;
  }
  EXPECT_GE(onEdge, 3);
}

TEST(AdaptiveRefinement, RefusesBadProperties)
{
  const auto filter = Filter(Scene());
  filter->SetRefinementTolerance(0.0);
  EXPECT_TRUE(Holds(ErrorOf(filter), "refinement tolerance is 0"));
  filter->SetRefinementTolerance(0.1);
  filter->SetMaximumCells(-1);
  EXPECT_TRUE(Holds(ErrorOf(filter), "MaximumCells is -1"));
}
