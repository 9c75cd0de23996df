// SPDX-License-Identifier: BSD-3-Clause
// Point normals as they come: of any type, name, length, in part, not at all.
#include "FilterTools.h"
#include "RoomMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"

#include <cmath>
#include <limits>
#include <vector>

namespace
{

class FilterNormals : public FilterTest
{
protected:
  FilterNormals()
    : FilterTest("normals of any type, length and absence: NaN in the map, the wrong side lit")
  {
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    this->Given = this->Surface->GetPointData()->GetNormals();
  }

  /// The given normals times a factor in an array of another kind.
  template <class Array>
  vtkSmartPointer<Array> Copy(double factor) const
  {
    auto copy = vtkSmartPointer<Array>::New();
    copy->SetName("Normals");
    copy->SetNumberOfComponents(3);
    copy->SetNumberOfTuples(this->Given->GetNumberOfTuples());
    for (vtkIdType i = 0; i < 3 * this->Given->GetNumberOfTuples(); ++i)
    {
      copy->SetComponent(i / 3, static_cast<int>(i % 3),
        factor * this->Given->GetComponent(i / 3, static_cast<int>(i % 3)));
    }
    return copy;
  }

  void Use(vtkDataArray* normals)
  {
    this->Surface->GetPointData()->Initialize();
    this->Surface->GetPointData()->SetNormals(normals);
  }

  std::vector<double> Map()
  {
    this->ExpectMap();
    std::vector<double> map;
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
    {
      map.push_back(this->OutputArray("Illuminance")->GetTuple1(i));
    }
    return map;
  }

  vtkSmartPointer<vtkDataArray> Given;
};

} // namespace

TEST_F(FilterNormals, OfAnyTypeAndLengthGiveTheSameBits)
{
  for (const int registration : { 0, 1, 2 })
  {
    this->Filter->SetRegistration(registration);
    this->Use(this->Given);
    const std::vector<double> expected = this->Map();
    // Powers of two cost no rounding.
    for (const double factor : { 1.0, 0x1p-66, 0x1p66 })
    {
      this->Use(this->Copy<vtkFloatArray>(factor));
      EXPECT_EQ(this->Map(), expected) << "float times " << factor;
      this->Use(this->Copy<vtkDoubleArray>(factor));
      EXPECT_EQ(this->Map(), expected) << "double times " << factor;
    }
    this->Use(this->Copy<vtkDoubleArray>(0x1p-1040)); // below the least normal double in part
    this->ExpectMap();
    this->Use(this->Copy<vtkDoubleArray>(0x1p1023));
    EXPECT_EQ(this->Map(), expected);
  }
}

TEST_F(FilterNormals, OfIntegersServeToo)
{
  const vtkSmartPointer<vtkIntArray> whole = this->Copy<vtkIntArray>(1e9);
  this->Use(whole);
  const std::vector<double> expected = this->Map();
  vtkNew<vtkDoubleArray> same;
  same->DeepCopy(whole);
  same->SetName("Normals");
  this->Use(same);
  EXPECT_EQ(this->Map(), expected);
}

TEST_F(FilterNormals, AreFoundByMarkOrByName)
{
  const std::vector<double> expected = this->Map();
  const vtkSmartPointer<vtkFloatArray> byName = this->Copy<vtkFloatArray>(1.0);
  this->Surface->GetPointData()->Initialize();
  this->Surface->GetPointData()->AddArray(byName);
  EXPECT_EQ(this->Map(), expected);
  // The mark goes before the name.
  const vtkSmartPointer<vtkFloatArray> marked = this->Copy<vtkFloatArray>(1.0);
  marked->SetName("Anything");
  byName->Fill(std::numeric_limits<float>::quiet_NaN());
  this->Surface->GetPointData()->SetNormals(marked);
  EXPECT_EQ(this->Map(), expected);
}

TEST_F(FilterNormals, MissingAreComputedAndSaid)
{
  // In flat registration normals only tell the sides, so computed ones must change nothing.
  this->Filter->SetRegistration(vtkIlluminationMap::FLAT);
  this->Filter->SetFeatureAngle(180.0);
  const std::vector<double> expected = this->Map();
  this->Surface->GetCellData()->SetNormals(this->Copy<vtkFloatArray>(1.0)); // of no use: per cell
  this->Surface->GetCellData()->GetNormals()->SetNumberOfTuples(this->Surface->GetNumberOfCells());
  this->Surface->GetPointData()->Initialize();
  EXPECT_EQ(this->Map(), expected);
  EXPECT_EQ(this->Notes(), "the points had no normals; they were computed\n");
}

TEST_F(FilterNormals, MissingInOneBlockAreComputedThere)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Surface);
  vtkSmartPointer<vtkPolyData> bare = SmallSphere();
  bare->GetPointData()->Initialize();
  blocks->SetBlock(1, bare);
  this->Filter->SetInputData(blocks);
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
  EXPECT_EQ(
    this->Notes().rfind("the points of block 2 had no normals; they were computed\n", 0), 0u);
  // Both blocks are the same sphere.
  EXPECT_NE(this->Notes().find("96 triangles are copies of others"), std::string::npos);
  EXPECT_EQ(this->Messages->Warnings, 0) << this->Messages->Text;
}

TEST_F(FilterNormals, WithoutADirectionAreReplacedAndCounted)
{
  const double inf = std::numeric_limits<double>::infinity();
  const vtkSmartPointer<vtkDoubleArray> normals = this->Copy<vtkDoubleArray>(1.0);
  normals->SetTuple3(3, 0.0, 0.0, 0.0);
  normals->SetTuple3(4, std::nan(""), 0.0, 1.0);
  normals->SetTuple3(5, 0.0, inf, 0.0);
  normals->SetTuple3(6, -0.0, 0.0, -0.0);
  this->Use(normals);
  for (const int registration : { 0, 1, 2 })
  {
    this->Filter->SetRegistration(registration);
    this->ExpectMap();
    EXPECT_EQ(this->Notes(),
      "4 point normals were zero or not finite; the mean of the facets around the point stands "
      "in\n");
  }
}

TEST_F(FilterNormals, InTheirFacetsPlaneGiveWayToTheWindingAndAreSaid)
{
  vtkNew<vtkPlaneSource> plane; // in z = 0, wound to look up
  plane->SetResolution(3, 3);
  plane->Update();
  this->Surface = plane->GetOutput();
  this->Filter->SetInputData(this->Surface);
  this->Given = this->Surface->GetPointData()->GetNormals();
  for (const int registration : { 0, 1, 2 })
  {
    SCOPED_TRACE(registration);
    this->Filter->SetRegistration(registration);
    this->Use(this->Given);
    const std::vector<double> expected = this->Map();
    EXPECT_EQ(this->Notes(), "");
    const vtkSmartPointer<vtkDoubleArray> inPlane = this->Copy<vtkDoubleArray>(1.0);
    for (const double lift : { 0.0, 1e-4, -1e-4 }) // as rounding may leave it
    {
      for (vtkIdType p = 0; p < inPlane->GetNumberOfTuples(); ++p)
      {
        inPlane->SetTuple3(p, 1.0, p % 2 == 0 ? 1.0 : -1.0, lift);
      }
      this->Use(inPlane);
      EXPECT_EQ(this->Map(), expected);
      EXPECT_NE(this->Notes().find("18 triangles, the first in cell 0, and 16 points, the first "
                                   "being point 0, have point normals that lie in the triangles' "
                                   "own plane"),
        std::string::npos)
        << this->Notes();
    }
    // One such normal among good ones: they decide its facets' front, the facets its direction.
    const vtkSmartPointer<vtkDoubleArray> one = this->Copy<vtkDoubleArray>(1.0);
    one->SetTuple3(5, 0.0, 1.0, 0.0);
    this->Use(one);
    EXPECT_EQ(this->Map(), expected);
    EXPECT_EQ(this->Notes().find("1 points, the first being point 5, have point normals"), 0u)
      << this->Notes();
  }
}

TEST_F(FilterNormals, OfPointsSharedAcrossASharpEdgeAreSaid)
{
  const std::string note = "are shared by facets that meet at more than 75 degrees";
  vtkSmartPointer<vtkPolyData> room = RandomRoom(1).Data(true, false);
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  this->Filter->SetLampPosition(0.0, 0.0, 0.0);
  this->Filter->SetInputData(room);
  this->ExpectMap();
  // All points on the box's edges, 4 cells long: 8 corners and 3 between, on each of 12 edges.
  EXPECT_NE(this->Notes().find("44 points, the first being point 0, " + note), std::string::npos)
    << this->Notes();
  this->Filter->SetInputData(RandomRoom(1).Data(true, true)); // the same with smooth normals
  this->ExpectMap();
  EXPECT_EQ(this->Notes().find("44 points"), 0u) << this->Notes();

  vtkNew<vtkPolyDataNormals> cure; // which the note names
  cure->SetInputData(room);
  cure->SplittingOn();
  cure->Update();
  this->Filter->SetInputData(cure->GetOutput());
  this->ExpectMap();
  EXPECT_EQ(this->Notes(), "");
}

TEST_F(FilterNormals, OfCoarseSmoothShapesAreNoSharpEdges)
{
  for (const double steepest : { 70.0, 80.0 }) // a column of which two sides meet at this angle
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    const double half = steepest * std::acos(-1.0) / 360.0;
    for (const double y : { 0.0, 1.0 })
    {
      points->InsertNextPoint(-std::cos(half), y, -std::sin(half));
      points->InsertNextPoint(0.0, y, 0.0);
      points->InsertNextPoint(std::cos(half), y, -std::sin(half));
      for (int i = 0; i < 3; ++i)
      {
        normals->InsertNextTuple3(0.0, 0.0, 1.0);
      }
    }
    vtkNew<vtkCellArray> squares;
    squares->InsertNextCell({ 0, 1, 4, 3 });
    squares->InsertNextCell({ 1, 2, 5, 4 });
    this->Surface = vtkSmartPointer<vtkPolyData>::New();
    this->Surface->SetPoints(points);
    this->Surface->SetPolys(squares);
    this->Surface->GetPointData()->SetNormals(normals);
    this->Filter->SetInputData(this->Surface);
    this->ExpectMap();
    EXPECT_EQ(this->Notes().empty(), steepest < 75.0) << this->Notes();
  }
}
