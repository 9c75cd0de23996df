// SPDX-License-Identifier: BSD-3-Clause
// Every kind of cell: polygons and strips count as triangles, vertices and lines stay unlit, and
// cell arrays are read in the order of vertices, lines, polygons, strips.
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(IlluminationMap, TakesEveryKindOfCell)
{
  // Three unit squares in a row: an L-shaped (concave) hexagon and a square make up the first two,
  // the third is a strip; one point more that only a line and a vertex use.
  vtkNew<vtkPoints> points;
  for (const auto& p : { std::pair<double, double>{ 0, 0 }, { 2, 0 }, { 2, 0.5 }, { 1, 0.5 },
         { 1, 1 }, { 0, 1 }, { 2, 1 }, { 3, 0 }, { 3, 1 }, { 9, 9 } })
  {
    points->InsertNextPoint(p.first, p.second, 0.0);
  }
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  vtkNew<vtkCellArray> verts, lines, polys, strips;
  const vtkIdType vert[] = { 9 }, line[] = { 0, 9 };
  const vtkIdType hexagon[] = { 0, 1, 2, 3, 4, 5 }, square[] = { 3, 2, 6, 4 };
  const vtkIdType strip[] = { 1, 7, 6, 8 }; // crosses the square's right edge at point 2
  verts->InsertNextCell(1, vert);
  lines->InsertNextCell(2, line);
  polys->InsertNextCell(6, hexagon);
  polys->InsertNextCell(4, square);
  strips->InsertNextCell(4, strip);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetVerts(verts);
  surface->SetLines(lines);
  surface->SetPolys(polys);
  surface->SetStrips(strips);
  surface->GetPointData()->SetNormals(normals);

  vtkNew<vtkFloatArray> exitance; // only the strip shines
  exitance->SetName("Exitance");
  for (const float value : { 7.0f, 7.0f, 0.0f, 0.0f, 100.0f })
  {
    exitance->InsertNextValue(value);
  }
  surface->GetCellData()->AddArray(exitance);

  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputData(surface);
  illuminate->SetRegistration(vtkIlluminationMap::FLAT);
  illuminate->SetPhotons(1000000);
  illuminate->Update();
  vtkPolyData* output = illuminate->GetOutput();
  vtkDataArray* map = PointArray(output, "Illuminance");
  EXPECT_TRUE(output->GetNumberOfCells() == 5 && output->GetNumberOfPoints() == 10)
    << "cells pass through";
  EXPECT_NE(map, nullptr) << "a map";
  for (vtkIdType i = 0; map && i < 9; ++i)
  {
    // Parallel light from straight above: 1000 lx at every point of the plane, within 5 standard
    // errors of 8 replicates (Student's t with 7 degrees of freedom: 0.2 %) or Sobol's remainder.
    const double tolerance = 5.0 * PointArray(output, "StandardError")->GetTuple1(i) + 1.0;
    EXPECT_LT(std::fabs(map->GetTuple1(i) - 1000.0), tolerance)
      << "point " << i << ": " << map->GetTuple1(i);
  }
  EXPECT_TRUE(map && map->GetTuple1(9) == 0.0) << "a point without a surface stays unlit";

  illuminate->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  illuminate->SetExitanceArray("Exitance");
  illuminate->Update();
  // The strip's square metre alone shines: 100 lm.
  EXPECT_LT(std::fabs(FieldValue(illuminate->GetOutput(), "EmittedFlux") - 100.0), 1e-3)
    << "cell values belong to the right cells";
}
