// SPDX-License-Identifier: BSD-3-Clause
// Cells of every shape: what shines is their area, so the flux that facets of 1 lm/m^2 emit says
// whether a cell was cut into the right triangles, none missing, none twice.
#include "FilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

constexpr double Pi = 3.14159265358979323846;

struct Corner
{
  double x, y;
};
using Corners = std::vector<Corner>;

Corners RegularPolygon(int corners)
{
  Corners polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * i / corners;
    polygon.push_back({ std::cos(angle), std::sin(angle) });
  }
  return polygon;
}

/// Every second corner drawn in: as concave as it has corners.
Corners Star(int corners)
{
  Corners star = RegularPolygon(corners);
  for (std::size_t i = 1; i < star.size(); i += 2)
  {
    star[i].x *= 0.3;
    star[i].y *= 0.3;
  }
  return star;
}

/// Deep, narrow notches, one above the other.
Corners Comb(int teeth)
{
  Corners comb = { { 0.0, 0.0 }, { 1.0, 0.0 } };
  for (int i = teeth - 1; i >= 0; --i)
  {
    comb.push_back({ (i + 0.9) / teeth, 1.0 });
    comb.push_back({ (i + 0.1) / teeth, 1.0 });
    comb.push_back({ (i + 0.05) / teeth, 0.05 });
  }
  return comb;
}

double Length(const Corners& polygon)
{
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  return length;
}

/// Twice the shoelace would be; positive where the corners run counterclockwise.
double Area(const Corners& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (a.x * b.y - b.x * a.y);
  }
  return area;
}

/// A plane cell at height 0.5 x + z.
class FilterShapes : public FilterTest
{
protected:
  FilterShapes()
    : FilterTest("polygons cut into wrong, missing or double triangles")
  {
    this->LightMayBeMissing = true; // a plane that shines lights nothing
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    this->Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
    this->Filter->SetExitanceArray("Exitance");
    this->Filter->SetInputData(this->Cells);
    this->Cells->SetPoints(vtkNew<vtkPoints>());
    this->Cells->GetPoints()->SetDataTypeToDouble();
    this->Cells->SetVerts(vtkNew<vtkCellArray>());
    this->Cells->SetLines(vtkNew<vtkCellArray>());
    this->Cells->SetPolys(vtkNew<vtkCellArray>());
    this->Cells->SetStrips(vtkNew<vtkCellArray>());
  }

  std::vector<vtkIdType> AddPoints(const Corners& corners, double z = 0.0)
  {
    std::vector<vtkIdType> ids;
    for (const Corner& c : corners)
    {
      ids.push_back(this->Cells->GetPoints()->InsertNextPoint(c.x, c.y, 0.5 * c.x + z));
    }
    return ids;
  }

  static void AddCell(vtkCellArray* cells, const std::vector<vtkIdType>& ids)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }

  /// Lets every cell shine with 1 lm/m^2 and compares.
  void ExpectFlux(double lumens, double tolerance)
  {
    vtkNew<vtkDoubleArray> exitance;
    exitance->SetName("Exitance");
    exitance->SetNumberOfTuples(this->Cells->GetNumberOfCells());
    exitance->Fill(1.0);
    this->Cells->GetCellData()->Initialize();
    this->Cells->GetCellData()->AddArray(exitance);
    this->ExpectMap();
    EXPECT_NEAR(FieldValue(this->Filter->GetOutput(), "EmittedFlux"), lumens, tolerance);
  }

  /// One polygon: its area on the slope, within what rounding can change. A coordinate is rounded
  /// to float in [-1, 1], at most 2^-25 of the scene's unit, which is at most twice half the extent
  /// of the polygon; moving all points by d changes the area by up to its outline times d. A
  /// facet's area is rounded by 2^-24 of itself.
  void ExpectArea(const Corners& polygon)
  {
    const double slope = std::hypot(1.0, 0.5);
    const double area = slope * std::fabs(Area(polygon));
    constexpr double Extent = 2.0; // of any polygon here
    const double moved = std::sqrt(3.0) * 0x1p-25 * Extent;
    ASSERT_GT(area, 0.0);
    this->Cells->GetPolys()->Initialize();
    this->Cells->GetPoints()->Initialize();
    this->Cells->GetPoints()->SetDataTypeToDouble();
    AddCell(this->Cells->GetPolys(), this->AddPoints(polygon));
    this->Cells->Modified();
    this->ExpectFlux(area, slope * Length(polygon) * moved + area * 0x1p-24);
    EXPECT_EQ(this->Notes().rfind("the points had no normals; they were computed\n", 0), 0u);
  }

  vtkNew<vtkPolyData> Cells;
};

} // namespace

TEST_F(FilterShapes, PolygonsOfThreeToAThousandCorners)
{
  for (const int corners : { 3, 4, 5, 6, 7, 17, 100, 1000 })
  {
    SCOPED_TRACE(corners);
    this->ExpectArea(RegularPolygon(corners));
  }
}

TEST_F(FilterShapes, ConcavePolygons)
{
  for (const int corners : { 4, 6, 8, 50, 500, 1000 })
  {
    SCOPED_TRACE(corners);
    this->ExpectArea(Star(corners));
  }
  for (const int teeth : { 1, 2, 3, 20, 300 })
  {
    SCOPED_TRACE(teeth);
    this->ExpectArea(Comb(teeth));
  }
}

TEST_F(FilterShapes, EveryStartAndWindingOfAConcaveQuadrilateral)
{
  Corners dart = { { 0.0, 0.0 }, { 1.0, -1.0 }, { 0.0, 1.0 }, { -1.0, -1.0 } };
  for (int turn = 0; turn < 8; ++turn)
  {
    SCOPED_TRACE(turn);
    this->ExpectArea(dart);
    std::rotate(dart.begin(), dart.begin() + 1, dart.end());
    if (turn == 3)
    {
      std::reverse(dart.begin(), dart.end());
    }
  }
}

TEST_F(FilterShapes, CornersOnALineAndTwice)
{
  const Corners square = { { 0.0, 0.0 }, { 0.25, 0.0 }, { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 },
    { 0.5, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.5 } };
  this->ExpectArea(square);
  Corners twice = square;
  twice.insert(twice.begin() + 3, twice[3]);
  this->ExpectArea(twice);
}

TEST_F(FilterShapes, LongStrip)
{
  Corners zigzag;
  constexpr int Steps = 1000;
  for (int i = 0; i <= Steps; ++i)
  {
    zigzag.push_back({ static_cast<double>(i) / Steps, 0.0 });
    zigzag.push_back({ static_cast<double>(i) / Steps, 1.0 });
  }
  AddCell(this->Cells->GetStrips(), this->AddPoints(zigzag));
  const double slope = std::hypot(1.0, 0.5);
  // The outline of a thousandfold strip: all of its edges.
  const double outline = Steps * 3.0;
  this->ExpectFlux(slope, slope * outline * std::sqrt(3.0) * 0x1p-25 + slope * 0x1p-24);
}

TEST_F(FilterShapes, CellsOfTooFewCornersAreNoSurface)
{
  const std::vector<vtkIdType> ids =
    this->AddPoints({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } });
  AddCell(this->Cells->GetVerts(), { ids[0] });
  AddCell(this->Cells->GetLines(), { ids[0], ids[2], ids[3] });
  AddCell(this->Cells->GetPolys(), {});
  AddCell(this->Cells->GetPolys(), { ids[0] });
  AddCell(this->Cells->GetPolys(), { ids[0], ids[1] });
  AddCell(this->Cells->GetPolys(), ids);
  AddCell(this->Cells->GetStrips(), {});
  AddCell(this->Cells->GetStrips(), { ids[0] });
  AddCell(this->Cells->GetStrips(), { ids[0], ids[1] });
  AddCell(this->Cells->GetStrips(), { ids[0], ids[1], ids[2] });
  const double slope = std::hypot(1.0, 0.5);
  this->ExpectFlux(1.5 * slope, 1.5 * slope * (6.0 * std::sqrt(3.0) * 0x1p-25 + 0x1p-24));
}

TEST_F(FilterShapes, PolygonThatCannotBeCutIsNoted)
{
  AddCell(this->Cells->GetPolys(), this->AddPoints({ { 5.0, 5.0 }, { 6.0, 5.0 }, { 5.0, 6.0 } }));
  const Corners bow = { { 0.0, 0.0 }, { 1.0, 1.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } };
  AddCell(this->Cells->GetPolys(), this->AddPoints(bow));
  const Corners line = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 }, { 3.0, 0.0 } };
  AddCell(this->Cells->GetPolys(), this->AddPoints(line));
  const Corners holeJoinedToItsOutline = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 },
    { 0.0, 0.0 }, { 0.25, 0.25 }, { 0.25, 0.75 }, { 0.75, 0.75 }, { 0.75, 0.25 }, { 0.25, 0.25 } };
  AddCell(this->Cells->GetPolys(), this->AddPoints(holeJoinedToItsOutline));
  this->Filter->SetLampType(vtkIlluminationMap::PARALLEL);
  this->ExpectMap();
  for (const char* note : { "2 polygons, the first being cell 1, cross or touch themselves: they "
                            "were left out, at least in part\n",
         "1 triangles or polygons, the first being cell 2, have no area and were left out\n" })
  {
    EXPECT_NE(this->Notes().find(note), std::string::npos) << this->Notes();
  }
}
