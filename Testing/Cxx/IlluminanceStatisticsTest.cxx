// SPDX-License-Identifier: BSD-3-Clause
// The statistics of maps and sensors: rows, columns, units, errors. The numbers of one part:
// Core/LightSummaryTest.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminanceStatistics.h"
#include "vtkIlluminationMap.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{

void AddPointValues(vtkDataSet* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
}

/// A square of 2 m in four quads whose map is 100 + 50 x lx, x from 0 to 2.
vtkSmartPointer<vtkPolyData> Wedge()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(2.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 2.0, 0.0);
  plane->SetResolution(2, 2);
  plane->Update();
  auto wedge = vtkSmartPointer<vtkPolyData>::New();
  wedge->DeepCopy(plane->GetOutput());
  std::vector<double> map;
  for (vtkIdType p = 0; p < wedge->GetNumberOfPoints(); ++p)
  {
    map.push_back(100.0 + 50.0 * wedge->GetPoint(p)[0]);
  }
  AddPointValues(wedge, "Illuminance", map);
  return wedge;
}

/// Sensors without cells.
vtkSmartPointer<vtkPolyData> Sensors(const std::vector<double>& values)
{
  auto sensors = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    points->InsertNextPoint(static_cast<double>(i), 0.0, 0.0);
  }
  sensors->SetPoints(points);
  AddPointValues(sensors, "Illuminance", values);
  return sensors;
}

double Value(vtkIlluminanceStatistics* statistics, const char* column, vtkIdType row = 0)
{
  statistics->Update();
  auto* table = vtkTable::SafeDownCast(statistics->GetOutputDataObject(0));
  vtkAbstractArray* array = table->GetRowData()->GetAbstractArray(column);
  return array && row < array->GetNumberOfTuples() ? array->GetVariantValue(row).ToDouble() : -1.0;
}

std::string Names(vtkIlluminanceStatistics* statistics)
{
  statistics->Update();
  auto* table = vtkTable::SafeDownCast(statistics->GetOutputDataObject(0));
  vtkAbstractArray* array = table->GetRowData()->GetAbstractArray("Name");
  std::string names;
  for (vtkIdType row = 0; array && row < array->GetNumberOfTuples(); ++row)
  {
    names += (row > 0 ? "," : "") + array->GetVariantValue(row).ToString();
  }
  return names;
}

bool HasColumn(vtkIlluminanceStatistics* statistics, const char* column)
{
  auto* table = vtkTable::SafeDownCast(statistics->GetOutputDataObject(0));
  return table->GetRowData()->HasArray(column) != 0;
}

} // namespace

TEST(IlluminanceStatistics, OfALinearMapAreExact)
{
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(Wedge());
  statistics->SetTarget(125.0);
  EXPECT_EQ(Names(statistics), "All");
  EXPECT_DOUBLE_EQ(Value(statistics, "Area"), 4.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Points"), 9.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean"), 150.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "MeanOfPoints"), 150.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Minimum"), 100.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Maximum"), 200.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "U0"), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Ud"), 0.5);
  EXPECT_DOUBLE_EQ(Value(statistics, "ShareAtTarget"), 0.75);
  EXPECT_DOUBLE_EQ(Value(statistics, "Flux"), 600.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "MeanLuminance"), 75.0 / vtkMath::Pi()) << "reflectance 0.5";
  EXPECT_FALSE(HasColumn(statistics, "MeanError")) << "nothing is known of the noise";
  EXPECT_TRUE(Holds(FieldText(statistics->GetOutputDataObject(0), "Notes"), "no errors"));
}

TEST(IlluminanceStatistics, UnitsAndMaintenance)
{
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(Wedge());
  statistics->SetMetresPerUnit(0.5);
  EXPECT_DOUBLE_EQ(Value(statistics, "Area"), 1.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Flux"), 150.0);
  statistics->SetMaintenanceFactor(0.8);
  statistics->SetTarget(100.0); // which 125 lx as new become
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean"), 120.0);
  EXPECT_NEAR(Value(statistics, "ShareAtTarget"), 0.75, 1e-12);
  EXPECT_DOUBLE_EQ(Value(statistics, "U0"), 2.0 / 3.0) << "no factor changes a quotient";
  statistics->SetUnit(vtkIlluminanceStatistics::FOOT_CANDLES);
  statistics->SetTarget(100.0 / 10.763910416709722);
  EXPECT_NEAR(Value(statistics, "Mean"), 120.0 / 10.7639, 1e-4);
  EXPECT_NEAR(Value(statistics, "ShareAtTarget"), 0.75, 1e-12);
  EXPECT_DOUBLE_EQ(Value(statistics, "Flux"), 120.0) << "lm in any unit of illuminance";
}

TEST(IlluminanceStatistics, RowsAreBlocksOrParts)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto wedge = Wedge();
  vtkNew<vtkIntArray> zone;
  zone->SetName("Zone");
  for (const int number : { 7, 3, 7, 3 }) // left half 7, right half 3
  {
    zone->InsertNextValue(number);
  }
  wedge->GetCellData()->AddArray(zone);
  blocks->SetBlock(0, wedge);
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, Sensors({ 10.0, 20.0, 60.0 }));
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "Desk");
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(blocks);
  EXPECT_EQ(Names(statistics), "Block 1,Desk") << "an empty block has no row";
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean", 0), 150.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean", 1), 30.0) << "of the points";
  EXPECT_DOUBLE_EQ(Value(statistics, "Area", 1), 0.0);
  statistics->SetPartArray("Zone");
  EXPECT_EQ(Names(statistics), "Desk,3,7");
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean", 1), 175.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Minimum", 1), 150.0) << "parts share points";
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean", 2), 125.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Points", 2), 6.0);

  vtkNew<vtkStringArray> names;
  names->SetName("Zone");
  for (const char* name : { "floor", "floor", "wall", "floor" })
  {
    names->InsertNextValue(name);
  }
  wedge->GetCellData()->AddArray(names);
  statistics->Modified();
  EXPECT_EQ(Names(statistics), "Desk,floor,wall");
  EXPECT_DOUBLE_EQ(Value(statistics, "Area", 1), 3.0);
}

TEST(IlluminanceStatistics, PartitionsOfACollectionAreOneBlock)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetNumberOfPartitions(0, 2);
  collection->SetPartition(0, 0, Wedge());
  collection->SetPartition(0, 1, Wedge());
  collection->SetNumberOfPartitions(1, 1);
  collection->SetPartition(1, 0, Sensors({ 5.0 }));
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Floor");
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(collection);
  statistics->Update();
  EXPECT_TRUE(Holds(Names(statistics), "Floor,Block ")) << Names(statistics);
  EXPECT_DOUBLE_EQ(Value(statistics, "Area", 0), 8.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Points", 0), 18.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean", 1), 5.0);
}

TEST(IlluminanceStatistics, SensorsOfAGridStandForTheirAreas)
{
  const auto grid = Wedge(); // nine points, whose quads do not count
  AddPointValues(grid, "Illuminance", { 1000, 150, 200, 100, 150, 200, 100, 150, 200 });
  std::vector<double> areas(9, 0.25);
  AddPointValues(grid, "SensorArea", areas);
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(grid);
  statistics->SetTarget(150.0);
  statistics->SetMetresPerUnit(0.001); // the areas are in square metres already
  EXPECT_DOUBLE_EQ(Value(statistics, "Area"), 2.25);
  EXPECT_NEAR(Value(statistics, "Mean"), 250.0, 1e-9) << "a corner counts as much as the middle";
  EXPECT_NEAR(Value(statistics, "U0"), 0.4, 1e-12);
  EXPECT_NEAR(Value(statistics, "ShareAtTarget"), 7.0 / 9.0, 1e-12);
  EXPECT_NEAR(Value(statistics, "Flux"), 0.25 * 2250.0, 1e-9);
  EXPECT_EQ(Value(statistics, "MeanLuminance"), 0.0);

  areas[4] = -1.0;
  AddPointValues(grid, "SensorArea", areas);
  EXPECT_TRUE(Holds(ErrorOf(statistics), "point 4: SensorArea is -1"));
}

TEST(IlluminanceStatistics, PointsThatAreNotValidAndGhostsDoNotCount)
{
  const auto sensors = Sensors({ std::nan(""), 20.0, 60.0, 1000.0 });
  AddPointValues(sensors, "Valid", { 0.0, 1.0, 1.0, 1.0 });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const int flag : { 0, 0, 0, int{ vtkDataSetAttributes::DUPLICATEPOINT } })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(flag));
  }
  sensors->GetPointData()->AddArray(ghosts);
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(sensors);
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean"), 40.0);
  EXPECT_DOUBLE_EQ(Value(statistics, "Points"), 2.0);
  EXPECT_TRUE(
    Holds(FieldText(statistics->GetOutputDataObject(0), "Notes"), "1 points are not valid"));
  const auto wedge = Wedge();
  AddPointValues(wedge, "Valid", { 0.0, 1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.0 });
  statistics->SetInputData(wedge);
  EXPECT_DOUBLE_EQ(Value(statistics, "Area"), 2.0)
    << "all triangles of the left half have a corner on its border";
  vtkNew<vtkImageData> grid; // any data set is a set of points
  grid->SetDimensions(2, 1, 1);
  AddPointValues(grid, "Illuminance", { 1.0, 3.0 });
  statistics->SetInputData(grid);
  EXPECT_DOUBLE_EQ(Value(statistics, "Mean"), 2.0);
}

TEST(IlluminanceStatistics, ReflectanceByArrayOrProperty)
{
  const auto wedge = Wedge();
  vtkNew<vtkDoubleArray> colours;
  colours->SetName("DiffuseReflectance");
  colours->SetNumberOfComponents(3);
  for (int cell = 0; cell < 4; ++cell)
  {
    colours->InsertNextTuple3(0.0, cell % 2, 0.0); // the right half, where the mean is 175
  }
  wedge->GetCellData()->AddArray(colours);
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputData(wedge);
  EXPECT_NEAR(Value(statistics, "MeanLuminance"), 0.7152 * 175.0 / 2.0 / vtkMath::Pi(), 1e-4);
  wedge->GetCellData()->RemoveArray("DiffuseReflectance");
  statistics->SetReflectance(0.8);
  EXPECT_DOUBLE_EQ(Value(statistics, "MeanLuminance"), 0.8 * 150.0 / vtkMath::Pi());
}

TEST(IlluminanceStatistics, ErrorsOfAMapByGroupsAndByStandardErrors)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(20);
  vtkNew<vtkIlluminationMap> map;
  map->SetInputConnection(sphere->GetOutputPort());
  map->SetPhotons(50000);
  map->SetSampling(vtkIlluminationMap::RANDOM);
  map->SetRegistration(vtkIlluminationMap::FLAT); // which counts photons
  map->SetGroupMeans(false);
  vtkNew<vtkIlluminanceStatistics> statistics;
  statistics->SetInputConnection(map->GetOutputPort());
  const double largest = Value(statistics, "FluxError");
  EXPECT_TRUE(Holds(FieldText(statistics->GetOutputDataObject(0), "Notes"), "'StandardError'"));
  map->SetGroupMeans(true);
  const double byGroups = Value(statistics, "FluxError");
  EXPECT_TRUE(Holds(FieldText(statistics->GetOutputDataObject(0), "Notes"), "four groups"));
  // Parallel light of 1000 lx, whose photons start over the sphere's circle: binomial in the share
  // of the circle that the facets' outline leaves dark. Four groups tell that within a factor of 4
  // (chi-squared with 3 degrees of freedom, all but 10^-3), and the bound is far above it.
  const double flux = Value(statistics, "Flux");
  const double all = FieldValue(map->GetOutputDataObject(0), "EmittedFlux");
  const double photons = FieldValue(map->GetOutputDataObject(0), "PhotonsEmitted");
  const double share = flux / all;
  const double expected = all * std::sqrt(share * (1.0 - share) / photons);
  EXPECT_GT(byGroups, 0.08 * expected);
  EXPECT_LT(byGroups, 2.4 * expected);
  EXPECT_GT(largest, byGroups);
  const double minimum = Value(statistics, "Minimum");
  EXPECT_GE(minimum, 0.0);
  EXPECT_LE(minimum, 3.0 * Value(statistics, "MinimumError")) << "half of the sphere is dark";
}

TEST(IlluminanceStatistics, BadInputGivesAnErrorAndAnEmptyTable)
{
  vtkNew<vtkIlluminanceStatistics> statistics;
  const auto wedge = Wedge();
  statistics->SetInputData(wedge);
  const auto expect = [&](const std::string& message)
  {
    const std::string error = ErrorOf(statistics);
    EXPECT_TRUE(Holds(error, message)) << error;
    EXPECT_EQ(Names(statistics), "");
  };
  statistics->SetIlluminanceArray("Lux");
  expect("there is no point array 'Lux'");
  statistics->SetIlluminanceArray("Illuminance");
  statistics->SetPartArray("Zone");
  expect("cell array 'Zone'");
  statistics->SetPartArray("None");
  statistics->SetReflectanceArray("Paint");
  expect("cell array 'Paint'");
  statistics->SetReflectanceArray("None");
  statistics->SetMaintenanceFactor(0.0);
  expect("MaintenanceFactor is 0; it must be within (0, 1]");
  statistics->SetMaintenanceFactor(1.0);
  statistics->SetTarget(std::nan(""));
  expect("Target is nan; it must be 0 or more");
  statistics->SetTarget(500.0);
  statistics->SetReflectance(1.1);
  expect("Reflectance is 1.1; it must be within [0, 1]");
  statistics->SetReflectance(0.5);
  statistics->SetMetresPerUnit(-1.0);
  expect("MetresPerUnit is -1; it must be greater than 0");
  statistics->SetMetresPerUnit(1.0);
  PointArray(wedge, "Illuminance")->SetTuple1(4, -2.0);
  statistics->Modified();
  expect("point 4: Illuminance is -2; it must be a finite number >= 0");
  statistics->SetInputData(vtkNew<vtkPolyData>());
  expect("no points");
  statistics->SetInputData(Wedge());
  EXPECT_TRUE(ErrorOf(statistics).empty()) << "after errors the filter works";
  EXPECT_EQ(Names(statistics), "All");
}

TEST(IlluminanceStatistics, AnAbortLeavesAnEmptyTable)
{
  std::vector<double> values(200000, 100.0);
  const auto sensors = Sensors(values);
  AddPointValues(sensors, "StandardError", std::vector<double>(values.size(), 1.0));
  vtkNew<vtkIlluminanceStatistics> statistics;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = statistics->AddObserver(vtkCommand::ProgressEvent, stop);
  statistics->SetInputData(sensors);
  EXPECT_EQ(Names(statistics), "");
  statistics->RemoveObserver(tag);
  statistics->SetAbortExecute(0);
  statistics->Modified();
  EXPECT_EQ(Names(statistics), "All");
}
