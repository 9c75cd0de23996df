// SPDX-License-Identifier: BSD-3-Clause
// A wall that is drawn once for each side, as in many models of cabins: both sheets lie in one
// place, or nearer than a float tells. Light belongs on the sheet that faces it, whichever comes
// first, and however the two are cut into triangles.
#include "FilterTools.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>

namespace
{

/// Where the upper sheet's four points are among the eight.
struct Sheets
{
  bool upperFirst;
  double gap;
  /// Corner that the lower sheet's square begins with, which decides how it is cut.
  int start;
};

class FilterSheets : public FilterTest
{
protected:
  FilterSheets()
    : FilterTest("walls drawn once for each side: light on the wrong sheet")
  {
  }

  static constexpr double Slope = 0.5;

  /// Two sheets over the unit square at height 0.5 x, fronts up and down.
  void SetSheets(const Sheets& sheets)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> squares;
    constexpr std::array<double, 4> X = { 0.0, 1.0, 1.0, 0.0 };
    constexpr std::array<double, 4> Y = { 0.0, 0.0, 1.0, 1.0 };
    for (int sheet = 0; sheet < 2; ++sheet)
    {
      const bool upper = (sheet == 0) == sheets.upperFirst;
      std::array<vtkIdType, 4> ids{};
      for (int i = 0; i < 4; ++i)
      {
        const auto corner = static_cast<std::size_t>(upper ? i : (sheets.start + 4 - i) % 4);
        const double z = Slope * X[corner] + (upper ? sheets.gap : 0.0);
        ids[static_cast<std::size_t>(i)] = points->InsertNextPoint(X[corner], Y[corner], z);
        normals->InsertNextTuple3(upper ? -Slope : Slope, 0.0, upper ? 1.0 : -1.0);
      }
      squares->InsertNextCell(4, ids.data());
    }
    this->Surface = vtkSmartPointer<vtkPolyData>::New();
    this->Surface->SetPoints(points);
    this->Surface->SetPolys(squares);
    this->Surface->GetPointData()->SetNormals(normals);
    this->Filter->SetInputData(this->Surface);
  }

  double FieldValue(const char* name)
  {
    return ::FieldValue(this->Filter->GetOutputDataObject(0), name);
  }

  /// Parallel light of 1000 lx straight down, within 6 standard errors of 8 replicates (Student's t
  /// with 7 degrees of freedom: 5 in 10 000; the noise of a map under parallel light is far smaller
  /// than that of independent photons) and the rounding of a flat map to 2^-22.
  void ExpectLightOnTheUpperSheetAlone(bool upperFirst)
  {
    const double lit = 1000.0 / std::hypot(1.0, Slope);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const bool upper = (i < 4) == upperFirst;
      const double tolerance =
        6.0 * this->OutputArray("StandardError")->GetTuple1(i) + lit * 0x1p-22;
      EXPECT_NEAR(this->OutputArray("Illuminance")->GetTuple1(i), upper ? lit : 0.0, tolerance);
      EXPECT_EQ(this->OutputArray("IlluminanceBack")->GetTuple1(i), 0.0) << "point " << i;
    }
    EXPECT_EQ(this->FieldValue("PhotonsEmitted"),
      this->FieldValue("PhotonsAbsorbed") + this->FieldValue("PhotonsEscaped"));
  }
};

} // namespace

TEST_F(FilterSheets, LightFallsOnTheSheetThatFacesIt)
{
  this->Filter->SetRegisterBackSide(true);
  this->Filter->SetPhotons(100000);
  for (const bool upperFirst : { true, false })
  {
    for (const double gap : { 0.0, 1e-7, 1e-6, 1e-3 })
    {
      for (const int start : { 0, 1 })
      {
        this->SetSheets({ upperFirst, gap, start });
        for (const int registration : { 0, 1, 2 })
        {
          SCOPED_TRACE(std::to_string(upperFirst) + ' ' + std::to_string(gap) + ' ' +
            std::to_string(start) + ' ' + std::to_string(registration));
          this->Filter->SetRegistration(registration);
          this->Filter->SetNumberOfThreads(1 + start);
          this->ExpectMap();
          this->ExpectLightOnTheUpperSheetAlone(upperFirst);
        }
      }
    }
  }
}

/// A room whose walls are drawn from inside and from outside: no photon of the lamp in it may come
/// out, and none may be counted on the outside.
TEST_F(FilterSheets, RoomOfDoubleWallsKeepsItsLight)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkPolyData> outside;
  outside->DeepCopy(cube->GetOutput());
  vtkNew<vtkPolyData> inside;
  inside->DeepCopy(outside);
  vtkDataArray* normals = inside->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double* n = normals->GetTuple3(i);
    normals->SetTuple3(i, -n[0], -n[1], -n[2]);
  }
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  this->Filter->SetLampPosition(0.1, 0.2, -0.1);
  this->Filter->SetReflectance(0.9);
  this->Filter->SetRegisterBackSide(true);
  this->Filter->SetPhotons(100000);
  for (const unsigned insideIs : { 0u, 1u })
  {
    vtkNew<vtkMultiBlockDataSet> walls;
    walls->SetBlock(insideIs, inside);
    walls->SetBlock(1 - insideIs, outside);
    this->Filter->SetInputData(walls);
    for (const int registration : { 0, 1, 2 })
    {
      this->Filter->SetRegistration(registration);
      this->Run();
      auto* output = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
      EXPECT_EQ(this->FieldValue("PhotonsEscaped"), 0.0);
      vtkPointData* lit = vtkPolyData::SafeDownCast(output->GetBlock(insideIs))->GetPointData();
      vtkPointData* dark =
        vtkPolyData::SafeDownCast(output->GetBlock(1 - insideIs))->GetPointData();
      EXPECT_GT(lit->GetArray("Illuminance")->GetRange()[0], 0.0);
      EXPECT_EQ(lit->GetArray("IlluminanceBack")->GetRange()[1], 0.0);
      EXPECT_EQ(dark->GetArray("Illuminance")->GetRange()[1], 0.0);
      EXPECT_EQ(dark->GetArray("IlluminanceBack")->GetRange()[1], 0.0);
    }
  }
}
