// SPDX-License-Identifier: BSD-3-Clause
// Data sets such as nobody would make, through VTK's own filters and ours: at most one error, no
// warning, no crash, and a map of finite numbers where there is no error. Each is a function of its
// number, which a failure tells. A hundred times as many with ILLUMINATION_LONG_TESTS=1.
#include "FilterTools.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

class FilterFuzz : public FilterTest
{
protected:
  FilterFuzz()
    : FilterTest("data sets that nobody thought of: crash, hang, NaN, a flood of messages")
  {
    this->LightMayBeMissing = true;
  }

  int Below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(this->Random); }

  /// Mostly in a small lattice, where points coincide and polygons cross and fold.
  double Coordinate()
  {
    return this->Below(3) > 0 ? this->Below(4)
                              : std::uniform_real_distribution<double>(0.0, 3.0)(this->Random);
  }

  vtkSmartPointer<vtkCellArray> Cells(int number, int longest, vtkIdType points)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (int i = 0; i < number; ++i)
    {
      std::vector<vtkIdType> ids(static_cast<std::size_t>(this->Below(longest + 1)));
      for (vtkIdType& id : ids)
      {
        id = this->Below(static_cast<int>(points));
      }
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    return cells;
  }

  vtkSmartPointer<vtkDoubleArray> Normals(vtkIdType points)
  {
    const double bad[] = { 0.0, std::numeric_limits<double>::quiet_NaN(), 1e200, 1e-200 };
    auto normals = vtkSmartPointer<vtkDoubleArray>::New();
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < points; ++i)
    {
      const double factor = this->Below(6) == 0 ? bad[this->Below(4)] : 1.0;
      normals->InsertNextTuple3(factor * (this->Below(5) - 2), factor * (this->Below(5) - 2),
        factor * (this->Below(5) - 2));
    }
    return normals;
  }

  void Draw(unsigned number)
  {
    this->Random.seed(number);
    const vtkIdType points = 3 + this->Below(20);
    this->Surface = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> places;
    places->SetDataType(this->Below(2) == 0 ? VTK_FLOAT : VTK_DOUBLE);
    for (vtkIdType i = 0; i < points; ++i)
    {
      places->InsertNextPoint(this->Coordinate(), this->Coordinate(), this->Coordinate());
    }
    this->Surface->SetPoints(places);
    this->Surface->SetVerts(this->Cells(this->Below(3), 2, points));
    this->Surface->SetLines(this->Cells(this->Below(3), 4, points));
    this->Surface->SetPolys(this->Cells(this->Below(12), this->Below(2) == 0 ? 3 : 9, points));
    this->Surface->SetStrips(this->Cells(this->Below(4), 6, points));
    if (this->Below(2) == 0)
    {
      this->Surface->GetPointData()->SetNormals(this->Normals(points));
    }
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetRegistration(this->Below(3));
    this->Filter->SetRegisterBackSide(this->Below(2) == 0);
    this->Filter->SetCurvedSurface(this->Below(2) == 0);
    this->Filter->SetNumberOfThreads(1 + this->Below(2));
    this->Filter->SetFeatureAngle(60.0 * this->Below(4));
    this->Filter->SetLampType(this->Below(vtkIlluminationMap::DISK + 1));
    this->Filter->SetPhotons(2048);
  }

  std::mt19937 Random;
};

} // namespace

TEST_F(FilterFuzz, AnyDataSetGivesAMapOrOneError)
{
  const char* longTests = std::getenv("ILLUMINATION_LONG_TESTS");
  const unsigned number = longTests && std::string(longTests) == "1" ? 200000 : 2000;
  unsigned maps = 0;
  for (unsigned i = 0; i < number && !this->HasFailure(); ++i)
  {
    SCOPED_TRACE("data set " + std::to_string(i));
    this->Draw(i);
    this->Run();
    EXPECT_LE(this->Messages->Errors, 1) << this->Messages->Text;
    this->ExpectNoOtherWarning();
    EXPECT_NE(this->Messages->Errors == 1, AllFinite(this->Filter->GetOutput()))
      << this->Messages->Text;
    maps += this->Messages->Errors == 0;
  }
  this->Measured(std::to_string(maps) + " maps of " + std::to_string(number) + " data sets");
  EXPECT_GT(maps, number / 2) << "most of what is drawn must be worth drawing";
}
