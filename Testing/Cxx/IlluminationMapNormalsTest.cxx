// SPDX-License-Identifier: BSD-3-Clause
// Input without point normals: they are computed with edges kept sharp, that is noted, and the
// points of the input come back with the flux that their parts received.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{

/// A cube of 8 points, 6 squares, wound so that the computed normals look inside.
vtkSmartPointer<vtkPolyData> Room()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  const vtkIdType faces[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
    { 0, 2, 6, 4 }, { 1, 5, 7, 3 } };
  vtkNew<vtkCellArray> polys;
  for (const auto& face : faces)
  {
    polys->InsertNextCell(4, face);
  }
  auto room = vtkSmartPointer<vtkPolyData>::New();
  room->SetPoints(points);
  room->SetPolys(polys);
  return room;
}

double SumOfValues(vtkDataArray* array)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetTuple1(i);
  }
  return sum;
}

} // namespace

TEST(IlluminationMap, ComputesNormalsThatAreMissing)
{
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputData(Room());
  illuminate->SetLampType(vtkIlluminationMap::POINT);
  illuminate->SetLampPosition(0.5, 0.5, 0.5);
  illuminate->SetLuminousFlux(600.0);
  illuminate->SetReflectance(0.0);
  for (const double angle : { 30.0, 120.0 }) // sharp edges, then one smooth surface
  {
    illuminate->SetFeatureAngle(angle);
    for (const int registration : { 0, 1, 2 })
    {
      illuminate->SetRegistration(registration);
      illuminate->Update();
      vtkPolyData* output = illuminate->GetOutput();
      EXPECT_EQ(output->GetNumberOfPoints(), 8) << "the input's own points come back";
      EXPECT_FALSE(PointArray(output, "Normals")) << "computed normals stay inside";
      EXPECT_TRUE(Holds(FieldText(output, "Notes"), "had no normals")) << "noted";
      if (angle == 30.0 || registration == vtkIlluminationMap::FLAT)
      {
        // The mean over the points is that over the walls, 600 lm on 6 m^2. (Corners differ: the
        // diagonal of a wall gives its ends a larger share.) Areas of the corners: 3 walls, each
        // with 1 or 2 of 12 triangles' thirds; sum A E is what is conserved, so weigh by hits.
        EXPECT_EQ(
          SumOfValues(PointArray(output, "PhotonHits")), 3.0 * FieldValue(output, "PhotonsEmitted"))
          << "every photon is counted at three corners";
        for (vtkIdType i = 0; i < 8; ++i)
        {
          const double e = PointArray(output, "Illuminance")->GetTuple1(i);
          EXPECT_TRUE(e > 80.0 && e < 120.0) << "corner " << e;
        }
      }
    }
  }
}
