// SPDX-License-Identifier: BSD-3-Clause
// The refinement filter: what it divides, arrays, blocks, ghosts, limits, errors, abort.
#include "Messages.h"
#include "OutputData.h"

#include "vtkSurfaceRefinement.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace
{

constexpr double Radius = 0.5;
const double Pi = vtkMath::Pi();

/// 16 by 8 facets, 22.5 degrees an edge.
vtkSmartPointer<vtkPolyData> Sphere(double firstAngle = 0.0, double lastAngle = 360.0)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(Radius);
  source->SetThetaResolution(lastAngle - firstAngle < 360.0 ? 8 : 16);
  source->SetPhiResolution(9);
  source->SetStartTheta(firstAngle);
  source->SetEndTheta(lastAngle);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithoutNormals(vtkPolyData* data)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(data->GetPoints());
  bare->SetPolys(data->GetPolys());
  return bare;
}

vtkSmartPointer<vtkPolyData> Refined(vtkPolyData* data, double edgeLength = 0.0)
{
  vtkNew<vtkSurfaceRefinement> refine;
  refine->SetInputData(data);
  refine->SetMaximumEdgeLength(edgeLength);
  EXPECT_EQ(ErrorOf(refine), "");
  return refine->GetOutput();
}

vtkIdType IdOf(vtkDataSetAttributes* arrays, const char* name, vtkIdType tuple)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(arrays->GetArray(name));
  return ids ? ids->GetValue(tuple) : -2;
}

using Place = std::array<double, 3>;

Place PlaceOf(vtkPolyData* data, vtkIdType point)
{
  Place place{};
  data->GetPoint(point, place.data());
  return place;
}

double Length(const Place& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

using EdgeBalance = std::map<std::pair<Place, Place>, int>;

/// Counts the facets of each edge, as a piece of space, that run along it one way less those that
/// run the other way. Cells for which `skip` is true do not count.
template <class Skip>
void AddEdges(vtkPolyData* data, EdgeBalance& edges, const Skip& skip)
{
  auto it = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size && !skip(it->GetCurrentCellId()); ++i)
    {
      const Place a = PlaceOf(data, ids[i]), b = PlaceOf(data, ids[(i + 1) % size]);
      edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
}

long OpenEdges(const std::vector<vtkPolyData*>& blocks)
{
  EdgeBalance edges;
  for (vtkPolyData* block : blocks)
  {
    AddEdges(block, edges, [](vtkIdType) { return false; });
  }
  return std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second != 0; });
}

void ExpectOwnPointsFirst(vtkPolyData* input, vtkPolyData* output)
{
  ASSERT_GE(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(PlaceOf(output, p), PlaceOf(input, p)) << "point " << p << " is unmoved";
    EXPECT_EQ(IdOf(output->GetPointData(), "OriginalPointIds", p), p);
  }
}

} // namespace

TEST(SurfaceRefinement, MakesACoarseSphereRound)
{
  const auto coarse = Sphere();
  const auto fine = Refined(coarse);
  ExpectOwnPointsFirst(coarse, fine);
  EXPECT_GT(fine->GetNumberOfCells(), 10 * coarse->GetNumberOfCells());
  EXPECT_EQ(OpenEdges({ fine }), 0) << "a closed surface stays closed";
  // The middle of an edge of the coarse sphere is this far off, relative to the radius.
  const double flat = 1.0 - std::cos(Pi / 16.0);
  for (vtkIdType p = 0; p < fine->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(Length(PlaceOf(fine, p)) / Radius, 1.0, 0.02 * flat) << "point " << p;
    const bool isNew = p >= coarse->GetNumberOfPoints();
    EXPECT_EQ(IdOf(fine->GetPointData(), "OriginalPointIds", p), isNew ? -1 : p);
  }
  EXPECT_FALSE(coarse->GetPointData()->HasArray("OriginalPointIds")) << "the input is untouched";
}

TEST(SurfaceRefinement, LeavesFlatFacetsWhole)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  EXPECT_EQ(Refined(cube->GetOutput())->GetNumberOfCells(), 12) << "two triangles a side";
  const auto small = Refined(cube->GetOutput(), 0.75);
  EXPECT_EQ(OpenEdges({ small }), 0);
  auto it = vtk::TakeSmartPointer(small->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    ASSERT_EQ(size, 3);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      const Place a = PlaceOf(small, ids[i]), b = PlaceOf(small, ids[(i + 1) % 3]);
      EXPECT_LE(Length({ b[0] - a[0], b[1] - a[1], b[2] - a[2] }), 0.75) << "unless too long";
    }
  }
}

TEST(SurfaceRefinement, KeepsToEachLimitAlone)
{
  // The middle of an arc of radius r and angle a is r (1 - cos(a / 2)) off its chord. With 22.5
  // degrees that is 0.0096, with 11.25 it is 0.0024, with 5.6 it is 0.0006 for a radius of 0.5.
  vtkNew<vtkCylinderSource> source;
  source->SetResolution(16);
  source->CappingOff();
  source->Update();
  const auto cells = [&](double turn, double tolerance)
  {
    vtkNew<vtkSurfaceRefinement> refine;
    refine->SetInputConnection(source->GetOutputPort());
    refine->SetMaximumTurn(turn);
    refine->SetCurvatureTolerance(tolerance);
    refine->Update();
    return refine->GetOutput()->GetNumberOfPolys();
  };
  EXPECT_EQ(cells(0.0, 0.0), 32) << "no limit, no division";
  EXPECT_EQ(cells(23.0, 0.0), 32);
  EXPECT_EQ(cells(0.0, 0.0097), 32);
  const vtkIdType once = cells(12.0, 0.0);
  EXPECT_GT(once, 32);
  EXPECT_EQ(cells(0.0, 0.003), once) << "either limit alone";
  EXPECT_GT(cells(6.0, 0.0), once);
  EXPECT_EQ(cells(0.0, 0.001), cells(6.0, 0.0));
}

TEST(SurfaceRefinement, ComputesNormalsWhereThereAreNone)
{
  vtkNew<vtkPolyData> welded; // one point at each corner, so that rims are sharp only by normals
  vtkNew<vtkPoints> points;
  for (int end = 0; end < 2; ++end)
  {
    for (int i = 0; i < 16; ++i)
    {
      points->InsertNextPoint(std::cos(i * Pi / 8.0), std::sin(i * Pi / 8.0), end);
    }
  }
  vtkNew<vtkCellArray> cells;
  vtkIdType bottom[16], top[16];
  for (vtkIdType i = 0; i < 16; ++i)
  {
    const vtkIdType next = (i + 1) % 16;
    const vtkIdType side[4] = { i, next, 16 + next, 16 + i };
    cells->InsertNextCell(4, side);
    bottom[i] = 15 - i;
    top[i] = 16 + i;
  }
  cells->InsertNextCell(16, bottom);
  cells->InsertNextCell(16, top);
  welded->SetPoints(points);
  welded->SetPolys(cells);
  const auto fine = Refined(welded);
  ExpectOwnPointsFirst(welded, fine);
  EXPECT_EQ(OpenEdges({ fine }), 0);
  vtkDataArray* normals = fine->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  EXPECT_STREQ(normals->GetName(), "Normals");
  int copies = 0;
  for (vtkIdType p = 0; p < fine->GetNumberOfPoints(); ++p)
  {
    const double* n = normals->GetTuple3(p);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-6);
    EXPECT_TRUE(std::fabs(n[2]) < 1e-6 || std::fabs(n[2]) > 1.0 - 1e-6)
      << "normals of sides and ends do not mix";
    const Place place = PlaceOf(fine, p);
    // VTK's mean over triangles counts one of two sides twice, so a normal lies at 7.46 in place of
    // 11.25 degrees between them, at both ends of a diagonal the other way. Its height is then
    // tan(3.73) / tan(5.63) = 0.66 of what it should be. Parabolas are off by (flat / 8) flat.
    const double flat = 1.0 - std::cos(Pi / 16.0);
    const bool onRim = place[2] == 0.0 || place[2] == 1.0;
    if (std::fabs(n[2]) < 0.5)
    {
      EXPECT_NEAR(std::hypot(place[0], place[1]), 1.0, onRim ? flat / 20.0 : 0.35 * flat)
        << "rims and sides become round";
    }
    const vtkIdType original = IdOf(fine->GetPointData(), "OriginalPointIds", p);
    if (p >= 32 && original >= 0)
    {
      ++copies;
      EXPECT_EQ(place, PlaceOf(welded, original)) << "a copy has the id of its original";
    }
  }
  EXPECT_EQ(copies, 32) << "points of the rims are split";

  vtkNew<vtkSurfaceRefinement> sharp;
  sharp->SetInputData(welded);
  sharp->SetFeatureAngle(20.0); // below the 22.5 degrees between sides
  sharp->Update();
  EXPECT_EQ(sharp->GetOutput()->GetNumberOfCells(), 16 * 2 + 2 * 14) << "then all is flat";
}

TEST(SurfaceRefinement, InterpolatesArrays)
{
  const auto coarse = Sphere();
  vtkNew<vtkDoubleArray> place; // linear in space, so exact on flat facets
  place->SetName("Double");
  vtkNew<vtkIntArray> part;
  part->SetName("Part");
  vtkNew<vtkStringArray> label;
  label->SetName("Label");
  vtkNew<vtkIdTypeArray> global;
  global->SetName("Global");
  vtkNew<vtkIntArray> cellPart;
  cellPart->SetName("CellPart");
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfComponents(3);
  for (vtkIdType p = 0; p < coarse->GetNumberOfPoints(); ++p)
  {
    place->InsertNextValue(static_cast<double>(p));
    part->InsertNextValue(static_cast<int>(1000 * p));
    label->InsertNextValue(std::to_string(p));
    global->InsertNextValue(p);
    colour->InsertNextTuple3(0.0, 0.0, p % 2 ? 200.0 : 0.0);
  }
  for (vtkIdType c = 0; c < coarse->GetNumberOfCells(); ++c)
  {
    cellPart->InsertNextValue(static_cast<int>(7 * c));
  }
  coarse->GetPointData()->AddArray(place);
  coarse->GetPointData()->AddArray(part);
  coarse->GetPointData()->AddArray(label);
  coarse->GetPointData()->SetGlobalIds(global);
  coarse->GetPointData()->AddArray(colour);
  coarse->GetCellData()->AddArray(cellPart);
  const auto fine = Refined(coarse);
  vtkDataArray* normals = fine->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr) << "normals are still the active ones";
  auto* labels = vtkStringArray::SafeDownCast(fine->GetPointData()->GetAbstractArray("Label"));
  ASSERT_NE(labels, nullptr);
  EXPECT_FALSE(fine->GetPointData()->HasArray("Global"));
  bool between = false, mixed = false;
  for (vtkIdType p = 0; p < fine->GetNumberOfPoints(); ++p)
  {
    const double* n = normals->GetTuple3(p);
    const Place x = PlaceOf(fine, p);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-6) << "normals have unit length";
    EXPECT_GT((n[0] * x[0] + n[1] * x[1] + n[2] * x[2]) / Length(x), std::cos(Pi / 180.0));
    const double number = PointArray(fine, "Double")->GetTuple1(p);
    const double whole = PointArray(fine, "Part")->GetTuple1(p);
    between = between || number != std::floor(number);
    EXPECT_EQ(std::fmod(whole, 1000.0), 0.0) << "whole numbers are those of a corner";
    EXPECT_EQ(std::to_string(static_cast<int>(whole / 1000.0)), labels->GetValue(p));
    const double blue = PointArray(fine, "Colour")->GetComponent(p, 2);
    mixed = mixed || (blue > 0.0 && blue < 200.0);
  }
  EXPECT_TRUE(between && mixed) << "numbers with a fraction and colours are interpolated";
  for (vtkIdType c = 0; c < fine->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(fine->GetCellData()->GetArray("CellPart")->GetTuple1(c),
      7.0 * static_cast<double>(IdOf(fine->GetCellData(), "OriginalCellIds", c)));
  }
}

TEST(SurfaceRefinement, InterpolatesLinearlyOnFlatFacets)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(2, 2);
  plane->Update();
  vtkPolyData* coarse = plane->GetOutput();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType p = 0; p < coarse->GetNumberOfPoints(); ++p)
  {
    height->InsertNextValue(3.0 * PlaceOf(coarse, p)[0] - 2.0 * PlaceOf(coarse, p)[1]);
  }
  coarse->GetPointData()->AddArray(height);
  const auto fine = Refined(coarse, 0.1);
  EXPECT_GT(fine->GetNumberOfPoints(), 100);
  for (vtkIdType p = 0; p < fine->GetNumberOfPoints(); ++p)
  {
    const Place x = PlaceOf(fine, p); // of single precision
    EXPECT_NEAR(PointArray(fine, "Height")->GetTuple1(p), 3.0 * x[0] - 2.0 * x[1], 1e-6);
  }
}

TEST(SurfaceRefinement, BlocksStayClosedWhereTheyMeet)
{
  const auto left = Sphere(0.0, 180.0);
  const auto right = Sphere(180.0, 360.0);
  for (const bool normals : { true, false })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, normals ? left : WithoutNormals(left));
    blocks->SetBlock(2, normals ? right : WithoutNormals(right));
    auto* inputs = blocks.Get();
    // vtkSphereSource computes the rims of the halves by different angles.
    for (vtkIdType p = 0; p < right->GetNumberOfPoints(); ++p)
    {
      for (vtkIdType q = 0; q < left->GetNumberOfPoints(); ++q)
      {
        const Place a = PlaceOf(right, p), b = PlaceOf(left, q);
        if (Length({ a[0] - b[0], a[1] - b[1], a[2] - b[2] }) < 1e-6)
        {
          right->GetPoints()->SetPoint(p, b.data());
        }
      }
    }
    ASSERT_EQ(OpenEdges({ left, right }), 0) << "the halves are closed together";
    vtkNew<vtkSurfaceRefinement> refine;
    refine->SetInputData(inputs);
    EXPECT_EQ(ErrorOf(refine), "");
    auto* output = vtkMultiBlockDataSet::SafeDownCast(refine->GetOutputDataObject(0));
    ASSERT_NE(output, nullptr);
    auto* first = vtkPolyData::SafeDownCast(output->GetBlock(0));
    auto* second = vtkPolyData::SafeDownCast(output->GetBlock(2));
    ASSERT_TRUE(first && second && !output->GetBlock(1));
    EXPECT_GT(first->GetNumberOfCells(), 4 * left->GetNumberOfCells());
    EXPECT_EQ(OpenEdges({ first, second }), 0);
    ExpectOwnPointsFirst(left, first);
    ExpectOwnPointsFirst(right, second);
  }
}

TEST(SurfaceRefinement, GhostCellsKeepTheirFlags)
{
  const auto coarse = Sphere();
  const vtkIdType cells = coarse->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> cellFlags, pointFlags;
  cellFlags->SetName(vtkDataSetAttributes::GhostArrayName());
  pointFlags->SetName(vtkDataSetAttributes::GhostArrayName());
  cellFlags->SetNumberOfValues(cells);
  pointFlags->SetNumberOfValues(coarse->GetNumberOfPoints());
  cellFlags->Fill(0);
  pointFlags->Fill(0);
  for (vtkIdType c = 0; c < cells / 4; ++c)
  {
    cellFlags->SetValue(c, vtkDataSetAttributes::DUPLICATECELL);
  }
  cellFlags->SetValue(cells - 1, vtkDataSetAttributes::HIDDENCELL);
  coarse->GetCellData()->AddArray(cellFlags);
  coarse->GetPointData()->AddArray(pointFlags);
  const auto fine = Refined(coarse);
  auto* flags = fine->GetCellGhostArray();
  ASSERT_NE(flags, nullptr);
  vtkIdType hidden = 0;
  std::vector<bool> owned(static_cast<std::size_t>(fine->GetNumberOfPoints()), false);
  auto it = vtk::TakeSmartPointer(fine->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    const vtkIdType c = it->GetCurrentCellId();
    const vtkIdType original = IdOf(fine->GetCellData(), "OriginalCellIds", c);
    EXPECT_EQ(flags->GetValue(c), cellFlags->GetValue(original));
    hidden += original == cells - 1;
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size && flags->GetValue(c) == 0; ++i)
    {
      owned[static_cast<std::size_t>(ids[i])] = true;
    }
  }
  EXPECT_EQ(hidden, 1) << "a hidden cell stays whole";
  for (vtkIdType p = coarse->GetNumberOfPoints(); p < fine->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(fine->GetPointGhostArray()->GetValue(p) == 0, owned[static_cast<std::size_t>(p)])
      << "new points that only duplicate cells use are duplicates";
  }
  // With the hidden cell back in place of its whole self, duplicates are divided as before.
  cellFlags->Fill(0);
  EXPECT_EQ(OpenEdges({ Refined(coarse) }), 0);
}

TEST(SurfaceRefinement, WhatIsNoSurfacePassesThrough)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& p : { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 0, 1, 0 }, Place{ 1, 1, 0 },
         Place{ 2, 0, 0 }, Place{ 5, 5, 5 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  vertices->InsertNextCell({ 5 });
  lines->InsertNextCell({ 0, 5 });
  polygons->InsertNextCell({ 0, 1, 4 }); // on a line
  polygons->InsertNextCell({ 0, 1, 3, 2 });
  strips->InsertNextCell({ 0, 1, 2, 3 });
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  const auto fine = Refined(data);
  EXPECT_EQ(fine->GetNumberOfVerts(), 1);
  EXPECT_EQ(fine->GetNumberOfLines(), 1);
  EXPECT_EQ(fine->GetPoints()->GetDataType(), VTK_DOUBLE);
  const vtkIdType expected[] = { 0, 1, 3, 3, 4, 4, 2 };
  ASSERT_EQ(fine->GetNumberOfCells(), 7);
  for (vtkIdType c = 0; c < 7; ++c)
  {
    EXPECT_EQ(IdOf(fine->GetCellData(), "OriginalCellIds", c), expected[c]) << c;
  }
}

TEST(SurfaceRefinement, AnEmptySurfaceIsNoError)
{
  vtkNew<vtkPolyData> empty;
  const auto fine = Refined(empty);
  EXPECT_EQ(fine->GetNumberOfCells(), 0);
  EXPECT_TRUE(fine->GetPointData()->HasArray("OriginalPointIds"));
}

TEST(SurfaceRefinement, MaximumCellsWidensTheLimits)
{
  const auto coarse = Sphere();
  vtkNew<vtkSurfaceRefinement> refine;
  refine->SetInputData(coarse);
  const auto warning = [&]()
  {
    const CaughtMessages messages;
    refine->Update();
    EXPECT_EQ(messages->Errors, 0) << messages->Text;
    EXPECT_LE(messages->Warnings, 1);
    return messages->Text;
  };
  refine->SetMaximumCells(1500);
  refine->SetMaximumEdgeLength(1e-9);
  std::string text = warning();
  EXPECT_TRUE(Holds(text, "more triangles than MaximumCells, 1500"));
  EXPECT_TRUE(Holds(text, "by wider limits:"));
  EXPECT_TRUE(Holds(text, "MaximumEdgeLength"));
  const vtkIdType found = refine->GetOutput()->GetNumberOfPolys();
  EXPECT_TRUE(found <= 1500 && found > coarse->GetNumberOfPolys()) << found;
  EXPECT_TRUE(Holds(text, "The surface has " + std::to_string(found)));
  EXPECT_EQ(OpenEdges({ refine->GetOutput() }), 0);

  refine->SetMaximumCells(1);
  EXPECT_TRUE(Holds(warning(), "none of them divided"));
  EXPECT_EQ(refine->GetOutput()->GetNumberOfPolys(), coarse->GetNumberOfPolys());
  refine->SetMaximumEdgeLength(0.0);
  refine->SetMaximumTurn(0.0);
  EXPECT_EQ(warning(), "") << "the input's own cells are no reason for a warning";
}

TEST(SurfaceRefinement, ErrorsLetTheInputPassThrough)
{
  const auto coarse = Sphere();
  vtkNew<vtkSurfaceRefinement> refine;
  refine->SetInputData(coarse);
  const auto expect = [&](const std::string& message)
  {
    EXPECT_TRUE(Holds(ErrorOf(refine), message));
    EXPECT_EQ(refine->GetOutput()->GetNumberOfCells(), coarse->GetNumberOfCells());
    EXPECT_FALSE(refine->GetOutput()->GetPointData()->HasArray("OriginalPointIds"));
  };
  refine->SetMaximumTurn(181.0);
  expect("MaximumTurn is 181; it must be within [0, 180] degrees");
  refine->SetMaximumTurn(7.0);
  refine->SetCurvatureTolerance(-1.0);
  expect("CurvatureTolerance is -1; it must be a finite length >= 0");
  refine->SetCurvatureTolerance(0.0);
  refine->SetMaximumEdgeLength(std::nan(""));
  expect("MaximumEdgeLength is nan; it must be a finite length >= 0");
  refine->SetMaximumEdgeLength(0.0);
  refine->SetFeatureAngle(-1.0);
  expect("FeatureAngle is -1; it must be within [0, 180] degrees");
  refine->SetFeatureAngle(30.0);
  refine->SetMaximumCells(0);
  expect("MaximumCells is 0; it must be from 1 to 1000000000");
  refine->SetMaximumCells(1000);
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(coarse);
  vtkNew<vtkFloatArray> shorter;
  shorter->SetName("Short");
  shorter->InsertNextValue(1.0f);
  broken->GetPointData()->AddArray(shorter);
  refine->SetInputData(broken);
  expect("point array 'Short' has 1 values for 114 points");
  broken->GetPointData()->RemoveArray("Short");
  broken->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  refine->Modified();
  expect("point 7: its coordinates");
  refine->SetInputData(coarse);
  EXPECT_EQ(ErrorOf(refine), "");
  EXPECT_GT(refine->GetOutput()->GetNumberOfCells(), coarse->GetNumberOfCells())
    << "after errors the filter works";
}

TEST(SurfaceRefinement, AnAbortLetsTheInputPassThrough)
{
  const auto coarse = Sphere();
  vtkNew<vtkSurfaceRefinement> refine;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  refine->SetInputData(coarse);
  const unsigned long tag = refine->AddObserver(vtkCommand::ProgressEvent, stop);
  refine->Update();
  EXPECT_EQ(refine->GetOutput()->GetNumberOfCells(), coarse->GetNumberOfCells());
  refine->RemoveObserver(tag);
  refine->SetAbortExecute(0);
  refine->Modified();
  refine->Update();
  EXPECT_GT(refine->GetOutput()->GetNumberOfCells(), coarse->GetNumberOfCells())
    << "and it runs again";
}
