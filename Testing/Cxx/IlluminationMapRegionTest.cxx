// SPDX-License-Identifier: BSD-3-Clause
// Where accuracy counts: a dim room beside a bright ground gets the error that was asked for.
#include "GatheringTools.h"
#include "Messages.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkTable.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

vtkSmartPointer<vtkPolyData> WithCellArray(vtkPolyData* surface, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(surface->GetNumberOfCells());
  array->Fill(value);
  auto with = vtkSmartPointer<vtkPolyData>::New();
  with->ShallowCopy(surface);
  with->GetCellData()->AddArray(array);
  return with;
}

/// Below the room, apart from it.
vtkSmartPointer<vtkPolyData> Ground()
{
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-5.0, -5.0, -2.0);
  ground->SetPoint1(5.0, -5.0, -2.0);
  ground->SetPoint2(-5.0, 5.0, -2.0);
  ground->SetXResolution(10);
  ground->SetYResolution(10);
  ground->Update();
  return ground->GetOutput();
}

/// The room has the first points and cells.
vtkSmartPointer<vtkPolyData> RoomAndGround(double inRoom, double onGround)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(WithCellArray(RoundRoom(12), "Region", inRoom));
  both->AddInputData(WithCellArray(Ground(), "Region", onGround));
  both->Update();
  return both->GetOutput();
}

/// A lamp in the room, and one of a hundred times its flux over the ground.
class RegionTest : public ::testing::TestWithParam<int>
{
protected:
  void SetUp() override
  {
    this->Filter = Gathering(RoomAndGround(2.0, 0.0), 200000000);
    this->Filter->SetMethod(GetParam());
    this->Filter->SetGatherRays(GetParam() == vtkIlluminationMap::FINAL_GATHERING ? 64 : 0);
    this->Filter->AddLuminaireConnection(this->InRoom->GetOutputPort());
    this->Filter->AddLuminaireConnection(this->Outside->GetOutputPort());
  }

  double Last(const char* column) const
  {
    auto* table = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1));
    vtkAbstractArray* values = table->GetColumnByName(column);
    return values ? values->GetVariantValue(values->GetNumberOfValues() - 1).ToDouble() : -1.0;
  }

  double Emitted() const { return FieldValue(this->Filter->GetOutput(), "PhotonsEmitted"); }

  vtkSmartPointer<vtkLuminaireSource> InRoom = PointLamp(0.1, 0.05, 0.15, 100.0, "Room");
  vtkSmartPointer<vtkLuminaireSource> Outside = PointLamp(0.0, 3.0, -1.0, 10000.0, "Outside");
  vtkSmartPointer<vtkIlluminationMap> Filter;
};

/// Area-weighted RMS of the standard error over the area-weighted mean illuminance of the first
/// cells.
double RelativeErrorOf(vtkPolyData* map, vtkIdType cells)
{
  double area = 0.0, flux = 0.0, squares = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    map->GetCellPoints(cell, corners);
    double p[3][3];
    for (int c = 0; c < 3; ++c)
    {
      map->GetPoint(corners->GetId(c), p[c]);
    }
    const double third = vtkTriangle::TriangleArea(p[0], p[1], p[2]) / 3.0;
    for (int c = 0; c < 3; ++c)
    {
      area += third;
      flux += third * PointArray(map, "Illuminance")->GetTuple1(corners->GetId(c));
      squares +=
        third * std::pow(PointArray(map, "StandardError")->GetTuple1(corners->GetId(c)), 2.0);
    }
  }
  return std::sqrt(squares / area) / (flux / area);
}

} // namespace

TEST_P(RegionTest, TheTargetHoldsInTheRegion)
{
  constexpr double Target = 0.05;
  const vtkIdType cells = RoundRoom(12)->GetNumberOfCells();
  this->Filter->SetTargetRelativeError(Target);
  this->Filter->Update();
  EXPECT_GT(RelativeErrorOf(this->Filter->GetOutput(), cells), Target)
    << "the bright ground alone has met it";
  EXPECT_EQ(this->Last("RegionRelativeError"), -1.0) << "no region, no column";
  const double before = this->Emitted();
  const double seconds = FieldValue(this->Filter->GetOutput(), "Seconds");

  this->Filter->SetAccuracyRegionArray("Region");
  this->Filter->Update();
  EXPECT_EQ(FieldText(this->Filter->GetOutput(), "StoppedBy"), "target relative error\n");
  EXPECT_GT(this->Emitted(), before);
  EXPECT_GT(FieldValue(this->Filter->GetOutput(), "Seconds"), seconds) << "it went on";
  const double error = this->Last("RegionRelativeError");
  EXPECT_LE(error, Target);
  EXPECT_LT(this->Last("RelativeError"), error);
  EXPECT_LE(this->Last("RegionMedianRelativeError"), this->Last("RegionPercentile95RelativeError"));
  // Areas are kept in single precision.
  EXPECT_NEAR(RelativeErrorOf(this->Filter->GetOutput(), cells), error, 1e-5 * error);
}

// A map depends on its photons alone, whichever region was asked for.
TEST_P(RegionTest, AnotherRegionKeepsTheRun)
{
  this->Filter->SetPhotons(20000);
  this->Filter->Update();
  vtkNew<vtkPolyData> map;
  map->ShallowCopy(this->Filter->GetOutput());
  const double seconds = FieldValue(map, "Seconds");
  for (const char* array : { "Region", "None", "Region", "" })
  {
    this->Filter->SetAccuracyRegionArray(array);
    this->Filter->Update();
    EXPECT_EQ(FieldValue(this->Filter->GetOutput(), "Seconds"), seconds) << "nothing to trace";
    EXPECT_TRUE(SameValues(
      PointArray(map, "Illuminance"), PointArray(this->Filter->GetOutput(), "Illuminance")));
    EXPECT_EQ(this->Last("RegionRelativeError") > 0.0, std::string(array) == "Region") << array;
  }
}

// A region of all cells is the whole, and any value but 0 is inside.
TEST_P(RegionTest, BlocksWithoutTheArrayAreOutside)
{
  vtkNew<vtkMultiBlockDataSet> blocks, marked;
  blocks->SetBlock(0, WithCellArray(RoundRoom(12), "Region", 1.0));
  blocks->SetBlock(1, Ground());
  marked->SetBlock(0, WithCellArray(RoundRoom(12), "Region", -0.5));
  marked->SetBlock(1, WithCellArray(Ground(), "Region", 0.0));
  this->Filter->SetPhotons(20000);
  this->Filter->SetAccuracyRegionArray("Region");
  this->Filter->SetInputData(blocks);
  this->Filter->Update();
  const double ofBlock = this->Last("RegionRelativeError");
  this->Filter->SetInputData(marked);
  this->Filter->Update();
  EXPECT_EQ(this->Last("RegionRelativeError"), ofBlock);
  this->Filter->SetInputData(RoomAndGround(1.0, 1.0));
  this->Filter->Update();
  for (const char* column : { "RelativeError", "MedianRelativeError", "Percentile95RelativeError" })
  {
    EXPECT_EQ(this->Last(("Region" + std::string(column)).c_str()), this->Last(column));
  }
}

// The region is then the same whether blocks or cells were chosen, and the run goes on.
TEST_P(RegionTest, ChosenBlocksAreTheRegion)
{
  vtkNew<vtkMultiBlockDataSet> rooms;
  rooms->SetBlock(0, WithCellArray(RoundRoom(12), "Region", 1.0));
  vtkNew<vtkMultiBlockDataSet> blocks; // flat indices: 1 the rooms, 2 the room, 3 the ground
  blocks->SetBlock(0, rooms);
  blocks->SetBlock(1, WithCellArray(Ground(), "Region", 0.0));
  this->Filter->SetPhotons(20000);
  this->Filter->SetAccuracyRegionArray("Region");
  this->Filter->SetInputData(blocks);
  this->Filter->Update();
  const double ofCells = this->Last("RegionRelativeError");
  const double seconds = FieldValue(this->Filter->GetOutputDataObject(0), "Seconds");
  this->Filter->SetAccuracyRegionArray("");
  for (const int block : { 1, 2 })
  {
    this->Filter->RemoveAllAccuracyRegionBlocks();
    this->Filter->AddAccuracyRegionBlock(block);
    this->Filter->Update();
    EXPECT_EQ(this->Last("RegionRelativeError"), ofCells) << block;
  }
  this->Filter->RemoveAllAccuracyRegionBlocks();
  this->Filter->AddAccuracyRegionBlock(3);
  this->Filter->Update();
  EXPECT_NE(this->Last("RegionRelativeError"), ofCells);
  this->Filter->AddAccuracyRegionBlock(2);
  this->Filter->Update();
  EXPECT_EQ(this->Last("RegionRelativeError"), this->Last("RelativeError"));
  this->Filter->SetAccuracyRegionArray("Region"); // of all blocks
  this->Filter->Update();
  EXPECT_EQ(this->Last("RegionRelativeError"), ofCells);
  EXPECT_EQ(FieldValue(this->Filter->GetOutputDataObject(0), "Seconds"), seconds)
    << "nothing to trace";
}

INSTANTIATE_TEST_SUITE_P(IlluminationMap, RegionTest,
  ::testing::Values(vtkIlluminationMap::PHOTON_TRACING, vtkIlluminationMap::FINAL_GATHERING));

TEST(IlluminationMap, RegionsThatAreNoneAreRefused)
{
  vtkSmartPointer<vtkIlluminationMap> filter = Gathering(RoomAndGround(0.0, 0.0), 4096);
  filter->SetAccuracyRegionArray("Elsewhere");
  EXPECT_TRUE(Holds(ErrorOf(filter), "there is no cell array 'Elsewhere'"));
  filter->SetAccuracyRegionArray("Region");
  EXPECT_TRUE(Holds(ErrorOf(filter), "no cell is in the region where accuracy counts"));
  filter->SetInputData(RoomAndGround(std::numeric_limits<double>::quiet_NaN(), 1.0));
  EXPECT_TRUE(Holds(ErrorOf(filter), "array 'Region' is nan"));
  filter->SetInputData(RoomAndGround(0.0, 1.0));
  EXPECT_EQ(ErrorOf(filter), "");

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, WithCellArray(Ground(), "Region", 0.0));
  blocks->SetBlock(1, WithCellArray(RoundRoom(12), "Region", 1.0));
  filter->SetInputData(blocks);
  filter->AddAccuracyRegionBlock(3);
  EXPECT_TRUE(Holds(
    ErrorOf(filter), "there is no block 3; the flat indices of the input's blocks are 0 to 2"));
  filter->RemoveAllAccuracyRegionBlocks();
  filter->AddAccuracyRegionBlock(1);
  EXPECT_TRUE(Holds(ErrorOf(filter), "'Region' (AccuracyRegionArray) is 0 everywhere"));
  filter->SetAccuracyRegionArray("None");
  EXPECT_EQ(ErrorOf(filter), "");
}
